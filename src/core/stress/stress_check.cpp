// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/stress_check.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/option_check.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
void requireStressInput(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson)
{
  if (pressure.rows() != grid.nx || pressure.cols() != grid.ny)
  {
    throw std::invalid_argument("pressure has " + std::to_string(pressure.rows()) + " x " +
                                std::to_string(pressure.cols()) + " values, the grid has " + std::to_string(grid.nx) +
                                " x " + std::to_string(grid.ny) + " cells");
  }
  requirePositive("dx", grid.dx);
  requirePositive("dy", grid.dy);
  validate(Material{1, poisson, 0}, "material");
}

void requireDepth(double depth)
{
  require(std::isfinite(depth) && depth >= 0, "depth", depth, "must be finite and at least 0");
}
}  // namespace wheel_rail_contact::core
