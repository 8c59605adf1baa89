// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/normal/problem.h"

#include <stdexcept>
#include <string>

namespace wheel_rail_contact
{
namespace
{
/// (1 - nu²) / E of one half-space [1/Pa].
double compliance(const Material& material)
{
  if (!(material.young > 0))
  {
    throw std::invalid_argument("young = " + std::to_string(material.young) + " Pa: must be positive");
  }
  if (!(material.poisson > -1 && material.poisson <= 0.5))
  {
    throw std::invalid_argument("poisson = " + std::to_string(material.poisson) + ": must lie in (-1, 0.5]");
  }
  return (1 - material.poisson * material.poisson) / material.young;
}
}  // namespace

double contactModulus(const Material& first, const Material& second)
{
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
}  // namespace wheel_rail_contact
