// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/cell_aspect.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace aspect_ladder
{
namespace
{
constexpr double kRungsPerOctave = 8;
}

double aspect(int rung)
{
  return std::exp2(rung / kRungsPerOctave);
}

int nearestRung(double dx_over_dy)
{
  const double clamped = std::clamp(dx_over_dy, aspect(kLowest), aspect(kHighest));
  return static_cast<int>(std::lround(kRungsPerOctave * std::log2(clamped)));
}

Cell coveringCell(double length, double width, int nx, int ny)
{
  const double dx = length / nx, dy = width / ny;
  const double on_ladder = aspect(nearestRung(dx / dy));
  Cell cell;
  cell.dy = std::max(dy, dx / on_ladder);
  cell.dx = cell.dy * on_ladder;
  return cell;
}
}  // namespace aspect_ladder
}  // namespace wheel_rail_contact::core
