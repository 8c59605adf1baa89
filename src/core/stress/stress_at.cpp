// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include "core/option_check.h"
#include "core/stress/corner_stress.h"
#include "core/stress/stress_check.h"
#include "wheel_rail_contact/core/stress.h"

namespace wheel_rail_contact::core
{
namespace
{
void add(double factor, const Stress& part, Stress& sum)
{
  sum.xx += factor * part.xx;
  sum.yy += factor * part.yy;
  sum.zz += factor * part.zz;
  sum.yz += factor * part.yz;
  sum.xz += factor * part.xz;
  sum.xy += factor * part.xy;
}

/// Corner of cell (row, column) with the smallest coordinates.
Eigen::Vector3d corner(const PatchGrid& grid, int row, int column)
{
  return {grid.x(row) - 0.5 * grid.dx, grid.y(column) - 0.5 * grid.dy, 0};
}
}  // namespace

Stress stressAt(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson, const Eigen::Vector3d& point)
{
  requireStressInput(grid, pressure, poisson);
  requireDepth(point.z());
  require(std::isfinite(point.x()), "x", point.x(), "must be finite");
  require(std::isfinite(point.y()), "y", point.y(), "must be finite");
  const auto at = [&](int row, int column)
  { return row >= 0 && row < grid.nx && column >= 0 && column < grid.ny ? pressure(row, column) : 0.0; };
  Stress sum;
  for (int j = 0; j <= grid.ny; ++j)
  {
    for (int i = 0; i <= grid.nx; ++i)
    {
      // Each corner belongs to up to four cells. Most differences are zero outside of the contact.
      const double jump = at(i, j) - at(i - 1, j) - at(i, j - 1) + at(i - 1, j - 1);
      if (jump != 0)
      {
        const Eigen::Vector3d offset = point - corner(grid, i, j);
        if (offset.squaredNorm() == 0)
        {
          throw std::invalid_argument("depth = 0: must be above 0 at a corner of a cell, where xy is infinite");
        }
        add(jump, cornerStress(offset.x(), offset.y(), offset.z(), poisson), sum);
      }
    }
  }
  return sum;
}
}  // namespace wheel_rail_contact::core
