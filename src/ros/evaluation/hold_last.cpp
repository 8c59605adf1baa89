// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/hold_last.h"

#include <cinttypes>
#include <stdexcept>
#include <string>

#include "ros/evaluation/conversions.h"
#include "ros/evaluation/text.h"

namespace wheel_rail_contact
{
void HoldLast::apply(const boost::shared_ptr<WheelsetContact>& result)
{
  add(result->header.stamp, result->status, wheelsetPoseFromMessage(result->wheelset));
  if (isUsable(result->status))
  {
    last_ = holds() ? result : nullptr;
    return;
  }
  if (last_pose_ && solves_height_ && hasPose(result->wheelset))
  {
    setHeight(*result);
  }
  if (last_ && since_ <= longest_)
  {
    hold(*result);
  }
}

void HoldLast::follow(const ros::Time& stamp, std::uint8_t status, const core::WheelsetPose& pose)
{
  if (holds())
  {
    throw std::logic_error("contact/hold_last = " + std::to_string(longest_) + ": each result needs its message");
  }
  add(stamp, status, pose);
}

void HoldLast::add(const ros::Time& stamp, std::uint8_t status, const core::WheelsetPose& pose)
{
  if (stamp < stamp_)
  {
    forget();
  }
  stamp_ = stamp;
  if (isUsable(status))
  {
    last_pose_ = pose;
    since_ = 0;
  }
  else if (last_pose_ && ++since_ > memory)
  {
    forget();
  }
}

void HoldLast::forget()
{
  last_pose_.reset();
  last_.reset();
}

void HoldLast::setHeight(WheelsetContact& result) const
{
  core::WheelsetPose pose = wheelsetPoseFromMessage(result.wheelset);
  pose.z = last_pose_->z;
  pose.roll = last_pose_->roll;
  result.wheelset = toMessage(pose, result.wheelset.position.x);
}

void HoldLast::hold(WheelsetContact& result) const
{
  const bool has_pose = hasPose(result.wheelset);
  if (!has_pose)
  {
    result.wheelset = last_->wheelset;
    result.distance = last_->distance;
  }
  result.held = true;
  result.status_text = sentences(
      result.status_text,
      formatted("%sforces and patches are held from the result at %" PRIu32 ".%09" PRIu32 " s (%d of at most %d)",
                has_pose ? "" : "pose, ", last_->header.stamp.sec, last_->header.stamp.nsec, since_, longest_));
  result.left_wheel = last_->left_wheel;
  result.right_wheel = last_->right_wheel;
  result.rail_wrench = last_->rail_wrench;
  result.implausible_force = last_->implausible_force;
  result.left_rail = last_->left_rail;
  result.right_rail = last_->right_rail;
  result.patches = last_->patches;
  const double advance = result.wheelset.position.x - last_->wheelset.position.x;
  for (ContactPatch& patch : result.patches)
  {
    patch.pose.position.x += advance;
  }
}
}  // namespace wheel_rail_contact
