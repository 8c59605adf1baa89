// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/hold_last.h"

#include <cinttypes>

#include "config/text.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
void HoldLast::apply(ContactOutput& output)
{
  if (output.header.stamp < stamp_)
  {
    last_.reset();
  }
  stamp_ = output.header.stamp;
  if (isUsable(output.status))
  {
    last_ = output;
    since_ = 0;
  }
  else if (last_ && ++since_ > memory)
  {
    last_.reset();
  }
  else if (last_)
  {
    if (solves_height_ && !output.rejected)
    {
      output.state.z = last_->pose().z;
      output.state.roll = last_->pose().roll;
    }
    if (since_ <= longest_)
    {
      hold(output);
    }
  }
}

void HoldLast::hold(ContactOutput& output) const
{
  auto result = std::make_shared<core::WheelsetResult>(*last_->result);
  result->derivatives = {};  // held forces do not change
  output.reason = sentences(
      output.reason,
      formatted("%sforces and patches are held from the result at %" PRIu32 ".%09" PRIu32 " s (%d of at most %d)",
                output.rejected ? "pose, " : "", last_->header.stamp.sec, last_->header.stamp.nsec, since_, longest_));
  if (output.rejected)
  {
    output.state = last_->state;
    output.rejected = false;
  }
  else
  {
    result->x = output.state.x;
    result->y = output.state.y;
    result->z = output.state.z;
    result->yaw = output.state.yaw;
    result->roll = output.state.roll;
    result->distance = output.state.distance;
  }
  output.result = std::move(result);
  output.held = true;
}
}  // namespace wheel_rail_contact
