// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/contact_evaluator.h"

#include "config/compliance_table_file.h"
#include "config/text.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
ContactEvaluator::ContactEvaluator(const NodeConfig& config)
    : track_frame_(config.track_frame), linear_range_(config.linear_range), contact_(config.model)
{
  for (const std::string& warning : config.warnings)
  {
    warnings_ = sentences(warnings_, warning);
  }
}

core::WheelsetPose ContactOutput::pose() const
{
  return result ? core::WheelsetPose{result->y, result->z, result->yaw, result->roll}
                : core::WheelsetPose{state.y, state.z, state.yaw, state.roll};
}

void ContactOutput::release()
{
  const core::WheelsetPose last = pose();
  state.z = last.z;
  state.roll = last.roll;
  result.reset();
}

bool hasPose(const ContactOutput& output)
{
  return !output.rejected && output.pose().z != 0;
}

ContactOutput ContactEvaluator::evaluate(const PreparedInput& input)
{
  if (input.resets)
  {
    contact_.reset();
  }
  ContactOutput output;
  output.header.stamp = input.stamp;
  output.header.frame_id = track_frame_;
  output.status = input.status;
  output.reason = sentences(input.reason, input.resets ? warnings_ : "");
  if (input.status != WheelsetContact::OK)
  {
    output.rejected = true;
    return output;
  }
  const core::WheelsetResult& result = contact_.evaluate(input.state);
  output.status = toMessage(result.status);
  output.reason = sentences(result.reason, sentences(input.reason, input.resets ? warnings_ : ""));
  output.state = input.state;
  output.lacks_neighbour = input.lacks_neighbour;
  if (output.lacks_neighbour)
  {
    output.reason = sentences(output.reason, "forces of a neighbour are unknown, and taken as zero");
  }
  if (isUsable(result.status))
  {
    output.result = std::make_shared<const core::WheelsetResult>(result);
    output.beyond_linear_range = linearRangeWarning(result, linear_range_);
    output.reason = sentences(output.reason, output.beyond_linear_range);
  }
  return output;
}

WheelsetContact toMessage(const ContactOutput& output, bool with_grids)
{
  WheelsetContact message;
  if (output.result)
  {
    message = toMessage(*output.result, output.x(), with_grids);
  }
  message.wheelset = output.rejected ? geometry_msgs::Pose() : toMessage(output.pose(), output.x());
  message.distance = output.state.distance;
  message.header = output.header;
  message.status = output.status;
  message.status_text = output.reason;
  message.held = output.held;
  message.solve_time = output.solve_time;
  return message;
}

ContactOutput outputFromMessage(const WheelsetContact& message)
{
  core::WheelsetResult result = fromMessage(message);
  ContactOutput output;
  output.header = message.header;
  output.status = message.status;
  output.reason = message.status_text;
  output.rejected = !hasPose(message.wheelset);
  output.state.x = result.x = message.wheelset.position.x;
  output.state.distance = message.distance;
  output.state.y = result.y;
  output.state.z = result.z;
  output.state.yaw = result.yaw;
  output.state.roll = result.roll;
  output.held = message.held;
  output.solve_time = message.solve_time;
  if (isUsable(result.status) || message.held)
  {
    output.result = std::make_shared<const core::WheelsetResult>(std::move(result));
  }
  return output;
}
}  // namespace wheel_rail_contact
