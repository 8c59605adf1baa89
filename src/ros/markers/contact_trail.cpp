// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_trail.h"

#include "ros/markers/rail_motion.h"

namespace wheel_rail_contact
{
void ContactTrail::add(const ContactAnswer& answer, const core::PlacedRail* at_rest)
{
  if (answer.header.stamp < last_)
  {
    clear();
  }
  last_ = answer.header.stamp;
  if (!answer.result)
  {
    return;
  }
  for (const core::PatchResult& patch : answer.result->patches)
  {
    core::PatchPose pose = patch.pose;
    if (at_rest)
    {
      const core::RailDeflection& now = answer.result->rail.at(static_cast<std::size_t>(patch.side)).deflection;
      pose = carriedByRail(*at_rest, patch.side, now, {}, pose);
    }
    pose.x += answer.x;
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
