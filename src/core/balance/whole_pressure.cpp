// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/whole_pressure.h"

namespace wheel_rail_contact::core
{
void wholePressure(Side side, const Grid& grid, const Eigen::ArrayXXd& stored, Eigen::ArrayXXd& whole)
{
  whole.resize(grid.nx, grid.ny);
  if (grid.symmetric)
  {
    whole.bottomRows(grid.rows()) = stored;
    whole.topRows(grid.rows()) = stored.colwise().reverse();
  }
  else
  {
    whole = stored;
  }
  if (side == Side::right)
  {
    whole.rowwise().reverseInPlace();
  }
}
}  // namespace wheel_rail_contact::core
