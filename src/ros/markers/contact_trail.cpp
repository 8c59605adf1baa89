// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_trail.h"

#include "ros/markers/rail_motion.h"

namespace wheel_rail_contact
{
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
  for (const core::PatchResult& patch : output.result->patches)
  {
    core::PatchPose pose = patch.pose;
    if (at_rest)
    {
      const core::RailDeflection& now = output.result->rail[patch.side].deflection;
      pose = carriedByRail((*at_rest)[patch.side], patch.side, now, {}, pose);
    }
    pose.x += output.x();
    points_.push_back({patch.side, pose, patch.max_pressure});
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
