// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/overlap_shape.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
OverlapMismatch compareOverlap(const PatchGap& gap, const GapMinimum& paraboloid, double level)
{
  const Grid& grid = gap.grid;
  const double cosine = std::cos(paraboloid.angle), sine = std::sin(paraboloid.angle);
  double own = 0, ideal = 0, apart = 0;
  for (int j = 0; j < grid.ny; ++j)
  {
    const double y = grid.y(j) - paraboloid.y;
    for (int i = 0; i < grid.rows(); ++i)
    {
      const double x = grid.x(i) - paraboloid.x;
      const double first = cosine * x + sine * y, second = cosine * y - sine * x;
      const double smooth =
          paraboloid.gap + paraboloid.curvature.a * first * first + paraboloid.curvature.b * second * second;
      const double depth = std::max(level - gap.gap(i, j), 0.0), smooth_depth = std::max(level - smooth, 0.0);
      own += depth;
      ideal += smooth_depth;
      apart += std::abs(depth - smooth_depth);
    }
  }
  return own > 0 && ideal > 0 ? OverlapMismatch{std::abs(std::log(own / ideal)), 2 * apart / (own + ideal)}
                              : OverlapMismatch{};
}

GapMinimum momentParaboloid(const PatchGap& gap, double level)
{
  const Grid& grid = gap.grid;
  double sum = 0, x1 = 0, x2 = 0, y1 = 0, y2 = 0, deepest = 0;
  for (int j = 0; j < grid.ny; ++j)
  {
    double column = 0;
    for (int i = 0; i < grid.rows(); ++i)
    {
      const double depth = std::max(level - gap.gap(i, j), 0.0), x = grid.x(i);
      column += depth;
      deepest = std::max(deepest, depth);
      x1 += depth * x;
      x2 += depth * x * x;
    }
    const double y = grid.y(j);
    sum += column;
    y1 += column * y;
    y2 += column * y * y;
  }
  GapMinimum paraboloid;
  paraboloid.gap = level - deepest;
  paraboloid.x = grid.symmetric ? 0 : x1 / sum;
  paraboloid.y = y1 / sum;
  // The second moment of a paraboloid about its axis is a sixth of the squared semi-axis. That of a cell about its own
  // axis is added.
  const double half_x2 = 6 * (x2 / sum - paraboloid.x * paraboloid.x + grid.dx * grid.dx / 12);
  const double half_y2 = 6 * (y2 / sum - paraboloid.y * paraboloid.y + grid.dy * grid.dy / 12);
  paraboloid.curvature = {deepest / half_x2, deepest / half_y2};
  return paraboloid;
}
}  // namespace wheel_rail_contact::core
