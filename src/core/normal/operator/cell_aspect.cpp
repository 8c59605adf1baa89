// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/cell_aspect.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace cell_aspect
{
namespace
{
constexpr double aspects_per_octave = 8;
}

double aspect(int index)
{
  return std::exp2(index / aspects_per_octave);
}

int indexAbove(double value)
{
  return static_cast<int>(std::ceil(aspects_per_octave * std::log2(value)));
}

int nearestIndex(double dx_over_dy)
{
  const double clamped = std::clamp(dx_over_dy, aspect(lowest_index), aspect(highest_index));
  return static_cast<int>(std::lround(aspects_per_octave * std::log2(clamped)));
}

Cell coveringCell(double length, double width, int nx, int ny)
{
  const double dx = length / nx, dy = width / ny;
  const double rounded_aspect = aspect(nearestIndex(dx / dy));
  Cell cell;
  cell.dy = std::max(dy, dx / rounded_aspect);
  cell.dx = cell.dy * rounded_aspect;
  return cell;
}
}  // namespace cell_aspect
}  // namespace wheel_rail_contact::core
