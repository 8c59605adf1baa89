// SPDX-License-Identifier: BSD-3-Clause
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
}  // namespace

Stress stressAt(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson, const Eigen::Vector3d& point)
{
  requireStressInput(grid, pressure, poisson);
  requireDepth(point.z());
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
        add(jump,
            cornerStress(point.x() - grid.x(i) + 0.5 * grid.dx, point.y() - grid.y(j) + 0.5 * grid.dy, point.z(),
                         poisson),
            sum);
      }
    }
  }
  return sum;
}
}  // namespace wheel_rail_contact::core
