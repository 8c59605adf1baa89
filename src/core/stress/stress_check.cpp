// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/stress_check.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
void requireStressInput(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson)
{
  if (pressure.rows() != grid.nx || pressure.cols() != grid.ny)
  {
    throw std::invalid_argument("pressure has " + std::to_string(pressure.rows()) + " x " +
                                std::to_string(pressure.cols()) + " values, the grid has " + std::to_string(grid.nx) +
                                " x " + std::to_string(grid.ny) + " cells: both must be equal");
  }
  if (!pressure.allFinite())
  {
    throw std::invalid_argument("pressure has values that are not finite: all must be finite");
  }
  requirePositive("dx", grid.dx);
  requirePositive("dy", grid.dy);
  require(poisson > -1 && poisson <= 0.5, "poisson", poisson, "must be above -1 and at most 0.5");
}

void requireDepth(double depth)
{
  require(std::isfinite(depth) && depth >= 0, "depth", depth, "must be finite and at least 0");
}
}  // namespace wheel_rail_contact::core
