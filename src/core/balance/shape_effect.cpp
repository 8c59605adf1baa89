// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/shape_effect.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
ShapeEffect shapeEffect(Side side, const WheelsetBalance& balance, const Profile& profile, std::size_t island,
                        double max_pressure)
{
  const WheelContact& contact = balance.wheel(side).contact();
  const Island& of = balance.islands(side).islands()[island];
  const std::vector<SurfaceColumn>& columns = contact.grids().columns()[of.patch];
  const SurfaceColumn &begin = columns[static_cast<std::size_t>(of.first)],
                      &end = columns[static_cast<std::size_t>(of.last)];
  const ShapeError of_rail = contact.rail().profile().errorWithin(begin.rail_u, end.rail_u);
  const ShapeError of_wheel =
      profile.errorWithin(std::min(begin.wheel_u, end.wheel_u), std::max(begin.wheel_u, end.wheel_u));
  if (of_rail.missing || of_wheel.missing)
  {
    return {1, true};
  }
  const double curvature_error = std::hypot(of_rail.curvature, of_wheel.curvature);
  if (curvature_error == 0 || of.first == of.last)
  {
    return {};
  }
  const double width = static_cast<double>(of.last - of.first) * contact.problem().patches[of.patch].grid.dy;
  const double curvature = std::abs(end.wheel_slope - begin.wheel_slope) / width;
  const double position_error = std::hypot(of_rail.position, of_wheel.position);
  const double long_waves = 0.5 * curvature_error / curvature;
  const double short_waves =
      0.5 * contact.problem().modulus * std::sqrt(position_error * curvature_error) / max_pressure;
  return {std::min({long_waves, short_waves, 1.0}), false};
}
}  // namespace wheel_rail_contact::core
