// SPDX-License-Identifier: BSD-3-Clause
#include "continuity.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wheel_rail_contact::core::stability
{
namespace
{
std::vector<const PatchResult*> patchesOf(const WheelsetResult& result, Side side)
{
  std::vector<const PatchResult*> patches;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      patches.push_back(&patch);
    }
  }
  return patches;
}

bool isLower(const PatchResult* a, const PatchResult* b)
{
  return a->max_pressure < b->max_pressure;
}

/// Bound of the relative change of a wheel's highest pressure between two answers `distance` [m] apart in y, without a
/// jump. Both may be off by their estimated errors. A contact's own approach changes by the bodies' relative way along
/// its normal; that is at most three times the lateral way (a flange at 70 degrees, pushed up beside a tread), and
/// pressure goes with the root of the approach (Hertz): half of 3 * distance / approach. A rail that bends by its table
/// adds as much again.
double bound(const PatchResult& before, const PatchResult& after, double distance)
{
  return before.error_estimate + after.error_estimate + 3 * distance / std::min(before.approach, after.approach);
}
}  // namespace

Change changeBetween(const WheelsetResult& before, const WheelsetResult& after, double distance)
{
  Change change;
  for (const Side side : {Side::left, Side::right})
  {
    const auto first = patchesOf(before, side), second = patchesOf(after, side);
    change.jumped = change.jumped || first.size() != second.size();
    for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k)
    {
      const double way = std::hypot(first[k]->pose.y - second[k]->pose.y, first[k]->pose.z - second[k]->pose.z);
      change.jumped = change.jumped || way > far;
    }
    if (first.empty() || second.empty())
    {
      continue;
    }
    const PatchResult& p = **std::max_element(first.begin(), first.end(), isLower);
    const PatchResult& q = **std::max_element(second.begin(), second.end(), isLower);
    const double pressure = std::abs(q.max_pressure / p.max_pressure - 1), bounded_by = bound(p, q, distance);
    if (pressure * change.bounded_by >= change.pressure * bounded_by)
    {
      change.pressure = pressure;
      change.bounded_by = bounded_by;
    }
  }
  return change;
}
}  // namespace wheel_rail_contact::core::stability
