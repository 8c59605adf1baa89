// SPDX-License-Identifier: BSD-3-Clause
#include "continuity.h"

#include "../standard_headers.h"

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

/// Bound of the relative change of the highest pressure of a wheel [-], without a jump, between two states that are
/// `distance` [m] apart in y: the sum of
///  - both error estimates,
///  - 3 * distance / approach, for the change of the approach. The relative displacement of the bodies along the normal
///    is at most three times the lateral displacement (flange at 70 degrees that lifts the tread). The pressure is
///    proportional to the root of the approach (Hertz), which gives half of 3 * distance / approach. A rail that is
///    deflected by its compliance table adds the same amount.
double boundOf(const PatchResult& before, const PatchResult& after, double distance)
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
      const double moved = std::hypot(first[k]->pose.y - second[k]->pose.y, first[k]->pose.z - second[k]->pose.z);
      change.jumped = change.jumped || moved > far;
    }
    if (first.empty() || second.empty())
    {
      continue;
    }
    const PatchResult& p = **std::max_element(first.begin(), first.end(), isLower);
    const PatchResult& q = **std::max_element(second.begin(), second.end(), isLower);
    const double pressure = std::abs(q.max_pressure / p.max_pressure - 1), bound = boundOf(p, q, distance);
    if (pressure * change.bound >= change.pressure * bound)
    {
      change.pressure = pressure;
      change.bound = bound;
    }
  }
  return change;
}
}  // namespace wheel_rail_contact::core::stability
