// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/stripe_energy.h"

#include <algorithm>

#include "core/normal/operator/influence.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Smallest box of cells around a pressure; size in cells of the whole grid.
struct LoadedBox
{
  int rows = 0, columns = 0;
};

LoadedBox loadedBox(const Grid& grid, const double* p)
{
  const int rows = grid.rows();
  int first_row = rows, last_row = -1, first_column = grid.ny, last_column = -1;
  for (int cell = 0; cell < rows * grid.ny; ++cell)
  {
    if (p[cell] > 0)
    {
      first_row = std::min(first_row, cell % rows);
      last_row = std::max(last_row, cell % rows);
      first_column = std::min(first_column, cell / rows);
      last_column = std::max(last_column, cell / rows);
    }
  }
  const int height = grid.symmetric ? 2 * (last_row + 1) : last_row - first_row + 1;
  return last_row < 0 ? LoadedBox() : LoadedBox{height, last_column - first_column + 1};
}
}  // namespace

double stripeEnergy(const Grid& grid, const double* pressure)
{
  const LoadedBox box = loadedBox(grid, pressure);
  double energy = 0;
  for (int column = 0; column < box.columns; ++column)
  {
    for (int row = 0; row < box.rows; ++row)
    {
      const double pairs = (row > 0 ? 2.0 : 1.0) * (column > 0 ? 2.0 : 1.0) * (box.rows - row) * (box.columns - column);
      const double sign = column % 2 == 0 ? 1 : -1;
      energy += sign * pairs * pointInfluence(row * grid.dx, column * grid.dy, grid.dx, grid.dy);
    }
  }
  return energy;
}
}  // namespace wheel_rail_contact::core
