// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/rail_on_line.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
Sides<RailDeflection> displacementsAt(const LineStation& station, const Sides<PlanePoint>& at_rest)
{
  const double sine = std::clamp(station.cross_level / (at_rest.left.y + at_rest.right.y), -1.0, 1.0);
  Sides<RailDeflection> displaced;
  for (const Side side : sides)
  {
    const RailDeflection& in_plane = station.rail[side];
    const PlanePoint& rest = at_rest[side];
    const double tilt = sideSign(side) * std::asin(sine);  // raises the rail
    const double y = rest.y + in_plane.lateral, z = rest.z + in_plane.vertical;
    displaced[side] = {std::cos(tilt) * y - std::sin(tilt) * z - rest.y,
                       std::sin(tilt) * y + std::cos(tilt) * z - rest.z, in_plane.roll - tilt};
  }
  return displaced;
}

double tiltOf(const Sides<RailDeflection>& displaced, double half_base)
{
  return std::atan(0.5 * (displaced.left.vertical - displaced.right.vertical) / half_base);
}
}  // namespace wheel_rail_contact::core
