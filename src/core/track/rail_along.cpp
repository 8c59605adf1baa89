// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/rail_along.h"

#include <algorithm>
#include <utility>

namespace wheel_rail_contact::core
{
RailAlong::RailAlong(std::shared_ptr<const Profile> profile, const TrackConfig& track, Side side)
    : rail_(std::move(profile), track, side)
{
}

RailAlong::RailAlong(const RailSections& sections, const TrackConfig& track, Side side)
    : rail_(sections.parts().front().front().profile, track, side)
{
  const RailSeries& running = sections.parts().front();
  frames_.push_back(rail_.frame());
  for (std::size_t i = 1; i < running.size() && sections.placement() == RailSections::Placement::gauge; ++i)
  {
    frames_.push_back(running[i].profile == running[i - 1].profile
                          ? frames_.back()
                          : PlacedRail(running[i].profile, track, side).frame());
  }
  changing_.emplace(sections);
  moveTo(running.front().x);
}

bool RailAlong::moveTo(double x)
{
  if (!changing_ || !changing_->moveTo(x))
  {
    return false;
  }
  RailFrame frame = frames_.front();
  if (frames_.size() > 1)
  {
    const std::size_t index = changing_->section();
    const RailFrame& next = frames_[std::min(index + 1, frames_.size() - 1)];
    const double share = changing_->share();
    frame.y = frames_[index].y + share * (next.y - frames_[index].y);
    frame.z = frames_[index].z + share * (next.z - frames_[index].z);
  }
  rail_ = PlacedRail(changing_->profile(), frame);
  return true;
}
}  // namespace wheel_rail_contact::core
