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
constexpr double kAspectsPerOctave = 8;
}

double aspect(int index)
{
  return std::exp2(index / kAspectsPerOctave);
}

int indexAbove(double value)
{
  return static_cast<int>(std::ceil(kAspectsPerOctave * std::log2(value)));
}

int nearestIndex(double dx_over_dy)
{
  const double clamped = std::clamp(dx_over_dy, aspect(kLowest), aspect(kHighest));
  return static_cast<int>(std::lround(kAspectsPerOctave * std::log2(clamped)));
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
