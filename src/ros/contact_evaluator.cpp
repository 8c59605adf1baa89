// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/ros/contact_evaluator.h"

#include <algorithm>
#include <cmath>

#include "wheel_rail_contact/ros/conversions.h"

namespace wheel_rail_contact
{
ContactEvaluator::ContactEvaluator(const NodeConfig& config)
    : track_frame_(config.track_frame), linear_range_(config.linear_range), contact_(config.model)
{
}

ContactAnswer ContactEvaluator::answer(const ContactInput& input, const tf2::BufferCore& transforms)
{
  ContactAnswer answer;
  answer.header.stamp = input.pose->header.stamp;
  answer.header.frame_id = track_frame_;
  try
  {
    const PlacedState placed = toState(input, track_frame_, transforms);
    const WheelsetResult& result = contact_.evaluate(placed.state);
    answer.status = toMessage(result.status);
    answer.reason = result.reason;
    answer.x = placed.x;
    answer.pose = {placed.state.y, placed.state.z, placed.state.yaw, placed.state.roll};
    if (isUsable(result.status))
    {
      answer.result = &result;
      answer.pose = {result.y, result.z, result.yaw, result.roll};
      answer.beyond_linear_range = isBeyondLinearRange(result);
    }
  }
  catch (const UnusableInput& error)
  {
    answer.status = error.status();
    answer.reason = error.what();
  }
  return answer;
}

bool ContactEvaluator::isBeyondLinearRange(const WheelsetResult& result) const
{
  return std::any_of(result.rail.begin(), result.rail.end(),
                     [this](const RailResult& rail)
                     { return std::abs(rail.lateral_force) > linear_range_ * std::max(rail.vertical_force, 0.0); });
}

WheelsetContactMsg toMessage(const ContactAnswer& answer, bool with_grids, double solve_time)
{
  WheelsetContactMsg message;
  if (answer.result)
  {
    message = toMessage(*answer.result, answer.x, with_grids);
  }
  message.wheelset = toMessage(answer.pose, answer.x);
  message.header = answer.header;
  message.status = answer.status;
  message.status_text = answer.reason;
  message.solve_time = solve_time;
  return message;
}
}  // namespace wheel_rail_contact
