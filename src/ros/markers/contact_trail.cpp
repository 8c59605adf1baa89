// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_trail.h"

#include <cmath>
#include <utility>

#include "ros/markers/rail_motion.h"

namespace wheel_rail_contact
{
constexpr double longest_way = 2;  ///< between two results that are joined [m]

void ContactTrail::add(const ContactOutput& output, const std::optional<core::Sides<core::PlacedRail>>& at_rest)
{
  if (output.header.stamp < last_)
  {
    clear();
  }
  last_ = output.header.stamp;
  if (!output.result || output.held)
  {
    return;
  }
  const double way = output.x() - std::exchange(last_x_, output.x());
  for (const core::PatchResult& patch : output.result->patches)
  {
    const core::RailDeflection& now = output.result->rail[patch.side].deflection;
    core::PatchPose pose =
        at_rest ? carriedByRail((*at_rest)[patch.side], patch.side, now, {}, patch.pose) : patch.pose;
    pose.x += output.x();
    points_.push_back({patch.side, pose, patch.max_pressure, std::abs(way) < longest_way ? way : 0});
  }
}

void ContactTrail::limit(std::size_t count)
{
  while (points_.size() > count)
  {
    points_.pop_front();
  }
}
}  // namespace wheel_rail_contact
