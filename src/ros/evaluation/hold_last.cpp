// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/hold_last.h"

#include <Eigen/Geometry>
#include <cinttypes>

#include "ros/evaluation/conversions.h"
#include "ros/evaluation/text.h"

namespace wheel_rail_contact
{
namespace
{
core::WheelsetPose poseOf(const WheelsetContact& result)
{
  const auto& p = result.wheelset.position;
  const auto& o = result.wheelset.orientation;
  return toWheelsetPose(Eigen::Translation3d(p.x, p.y, p.z) * Eigen::Quaterniond(o.w, o.x, o.y, o.z).normalized());
}
}  // namespace

void HoldLast::apply(const boost::shared_ptr<WheelsetContact>& result)
{
  if (result->header.stamp < stamp_)
  {
    last_.reset();
  }
  stamp_ = result->header.stamp;
  if (isUsable(result->status))
  {
    last_ = result;
    since_ = 0;
    return;
  }
  if (last_ && ++since_ > memory)
  {
    last_.reset();
  }
  if (!last_)
  {
    return;
  }
  if (solves_height_)
  {
    setHeight(*result);
  }
  if (since_ <= longest_)
  {
    hold(*result);
  }
}

void HoldLast::setHeight(WheelsetContact& result) const
{
  core::WheelsetPose pose = poseOf(result);
  const core::WheelsetPose last = poseOf(*last_);
  pose.z = last.z;
  pose.roll = last.roll;
  result.wheelset = toMessage(pose, result.wheelset.position.x);
}

void HoldLast::hold(WheelsetContact& result) const
{
  result.held = true;
  result.status_text += formatted(
      "%sforces and patches are held from the result at %" PRIu32 ".%09" PRIu32 " s (%d of at most %d)",
      result.status_text.empty() ? "" : "; ", last_->header.stamp.sec, last_->header.stamp.nsec, since_, longest_);
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
