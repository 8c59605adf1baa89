// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/normal_problem.h"

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Compliance (1 - nu²) / E of one half-space [1/Pa].
double compliance(const Material& material)
{
  return (1 - material.poisson * material.poisson) / material.young;
}
}  // namespace

void validate(const Material& material, const std::string& option)
{
  requirePositive(option + "/young", material.young);
  require(material.poisson > -1 && material.poisson <= 0.5, option + "/poisson", material.poisson,
          "must be above -1 and at most 0.5");
  require(std::isfinite(material.yield) && material.yield >= 0, option + "/yield", material.yield,
          "must be finite and at least 0");
}

double contactModulus(const Material& first, const Material& second)
{
  validate(first, "first material");
  validate(second, "second material");
  return 1 / (compliance(first) + compliance(second));
}

const char* toString(SolveStatus status)
{
  switch (status)
  {
    case SolveStatus::converged:
      return "converged";
    case SolveStatus::no_contact:
      return "no contact";
    case SolveStatus::iteration_limit:
      return "iteration limit reached";
    case SolveStatus::stalled:
      return "stalled: the residual stopped decreasing above the tolerance";
    case SolveStatus::indefinite:
      return "the influence matrix is not positive definite";
    case SolveStatus::no_positive_curvature:
      return "the gap has no positive curvature where the method requires it";
    case SolveStatus::invalid_problem:
      return "invalid problem: NaN in the gap, no load, no cells, or a weight that is not positive";
  }
  return "unknown";
}
}  // namespace wheel_rail_contact::core
