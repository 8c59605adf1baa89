// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/track/gap.h"
#include "core/track/rail_search.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Part of a rail: x along the track, side axes, and a parameter of its profile [m].
struct RailRegion
{
  double x_least = 0, x_most = 0;
  double u_begin = 0, u_end = 0;
};

/// Part of the rail that a wheel overlaps in the intervals, with a margin. The wheel is `lower` below its place [m].
RailRegion overlapOf(const PlacedWheel& wheel, const PlacedRail& rail, const OverlapInterval* begin,
                     const OverlapInterval* end, double lower);

/// Finds the part that a Hertzian contact with the same overlap would need, with a margin.
/// @return false unless the separation has one minimum
bool findContact(const RailSearch& search, const PlacedWheel& wheel, const PlacedRail& rail,
                 const OverlapInterval& interval, double lower, RailRegion& part);

/// Region of the rail that contains the middles of the loaded cells of a grid and `margin` cells more on each side.
/// Without load, it is empty: its ends are infinite, in reverse order.
/// @param origin   of the grid
/// @param columns  of the grid
RailRegion loadedPart(const PatchPressure& patch, const SurfaceOrigin& origin,
                      const std::vector<SurfaceColumn>& columns, double margin);
}  // namespace wheel_rail_contact::core
