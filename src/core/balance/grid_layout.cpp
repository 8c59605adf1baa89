// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/grid_layout.h"

#include <algorithm>
#include <cmath>

#include "core/normal/operator/operator_cache.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double smallest_cell = 1e-9;  ///< [m]
}  // namespace

bool GridLayout::equals(const GridLayout& other) const
{
  const auto near = [](double one, double two, double cell) { return std::abs(one - two) < 0.5 * cell; };
  return grid.nx == other.grid.nx && grid.ny == other.grid.ny && grid.dx == other.grid.dx && grid.dy == other.grid.dy &&
         near(origin.x, other.origin.x, grid.dx) &&
         near(origin.rail_u + grid.y0, other.origin.rail_u + other.grid.y0, grid.dy);
}

GridLayout layGrid(const SurfaceArea& area, const GridSize& size, bool symmetric)
{
  GridLayout layout;
  Grid& grid = layout.grid;
  grid.nx = size.along;
  grid.ny = size.across;
  grid.symmetric = symmetric;
  // One cell is left for the position at multiples of the cells.
  const double least_dx = (area.x_most - area.x_least) / (symmetric ? grid.nx : grid.nx - 1);
  const double least_dy = (area.arc_most - area.arc_least) / (grid.ny - 1);
  const auto index = [](double least)
  { return cell_aspect::indexAbove(std::max(least, smallest_cell) / smallest_cell); };
  const int along = std::max(index(least_dx), index(least_dy) + cell_aspect::lowest_index);
  const int across = std::max(index(least_dy), along - cell_aspect::highest_index);
  grid.dx = smallest_cell * cell_aspect::aspect(along);
  grid.dy = smallest_cell * cell_aspect::aspect(across);
  const double place = std::round(area.origin.rail_u / grid.dy) * grid.dy;
  const double moved = place - area.origin.rail_u;
  const double middle = 0.5 * (area.arc_least + area.arc_most) - moved;
  layout.origin = {symmetric ? 0 : std::round(0.5 * (area.x_least + area.x_most) / grid.dx) * grid.dx, place,
                   area.origin.wheel_u + moved};
  grid.y0 = std::round(middle / grid.dy - 0.5 * (grid.ny - 1)) * grid.dy;
  return layout;
}

bool covers(const GridLayout& layout, const SurfaceArea& area, double shift, double most_larger)
{
  const Grid& grid = layout.grid;
  const double low = grid.y(0) - 0.5 * grid.dy, high = grid.y(grid.ny - 1) + 0.5 * grid.dy;
  const double half = 0.5 * grid.nx * grid.dx;
  return area.arc_least + shift > low && area.arc_most + shift < high && area.x_least > layout.origin.x - half &&
         area.x_most < layout.origin.x + half && 2 * half < most_larger * (area.x_most - area.x_least) &&
         high - low < most_larger * (area.arc_most - area.arc_least);
}
}  // namespace wheel_rail_contact::core
