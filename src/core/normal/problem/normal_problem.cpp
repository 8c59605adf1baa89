// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/normal_problem.h"

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
/// (1 - nu^2) / E of one half-space [1/Pa].
double compliance(const Material& material)
{
  return (1 - material.poisson * material.poisson) / material.young;
}
}  // namespace

void validate(const Material& material, const std::string& option)
{
  requirePositive(option + "/young", material.young);
  require(material.poisson > -1 && material.poisson <= 0.5, option + "/poisson", material.poisson,
          "must lie above -1 and not above 0.5");
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
      return "stalled: the residual stopped falling above the tolerance";
    case SolveStatus::indefinite:
      return "the influence matrix has a negative direction";
    case SolveStatus::no_positive_curvature:
      return "the gap's curvature is not positive where the method needs it";
    case SolveStatus::invalid_problem:
      return "invalid problem: not a number in the gap, no load, no cells, or a plane past the vertical";
  }
  return "unknown";
}
}  // namespace wheel_rail_contact::core
