// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/contact_evaluator.h"

#include <algorithm>
#include <cmath>

#include "ros/node/conversions.h"
#include "ros/node/text.h"

namespace wheel_rail_contact
{
namespace
{
std::string rangeWarning(core::Side side, const core::RailResult& rail, double linear_range)
{
  return formatted("%s rail: Y = %.1f kN at Q = %.1f kN, |Y|/Q = %.3f; its compliance table holds up to %g",
                   sideName(side), 1e-3 * rail.lateral_force, 1e-3 * rail.vertical_force,
                   std::abs(rail.lateral_force / rail.vertical_force), linear_range);
}

void append(const std::string& sentence, std::string& text)
{
  text += text.empty() || sentence.empty() ? sentence : "; " + sentence;
}
}  // namespace

std::string linearRangeWarning(const core::WheelsetResult& result, double linear_range)
{
  std::string text;
  for (const core::Side side : {core::Side::left, core::Side::right})
  {
    const core::RailResult& rail = result.rail[static_cast<std::size_t>(side)];
    if (std::abs(rail.lateral_force) > linear_range * std::max(rail.vertical_force, 0.0))
    {
      append(rangeWarning(side, rail, linear_range), text);
    }
  }
  return text;
}

ContactEvaluator::ContactEvaluator(const NodeConfig& config)
    : track_frame_(config.track_frame), linear_range_(config.linear_range), contact_(config.model)
{
}

ContactAnswer ContactEvaluator::answer(const PreparedInput& input)
{
  if (input.starts_anew)
  {
    contact_.reset();
  }
  ContactAnswer answer;
  answer.header.stamp = input.stamp;
  answer.header.frame_id = track_frame_;
  answer.status = input.status;
  answer.reason = input.reason;
  if (input.status != WheelsetContact::OK)
  {
    return answer;
  }
  const core::WheelsetState& state = input.placed.state;
  const core::WheelsetResult& result = contact_.evaluate(state);
  answer.status = toMessage(result.status);
  answer.reason = result.reason;
  answer.lacks_neighbour = input.lacks_neighbour;
  answer.x = input.placed.x;
  answer.pose = {state.y, state.z, state.yaw, state.roll};
  if (isUsable(result.status))
  {
    answer.result = &result;
    answer.pose = {result.y, result.z, result.yaw, result.roll};
    answer.beyond_linear_range = linearRangeWarning(result, linear_range_);
    append(answer.beyond_linear_range, answer.reason);
    answer.above_tolerance = result.above_tolerance;
  }
  return answer;
}

WheelsetContact toMessage(const ContactAnswer& answer, bool with_grids, double solve_time)
{
  WheelsetContact message;
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

ContactAnswer answerFromMessage(const WheelsetContact& message, core::WheelsetResult& result)
{
  result = fromMessage(message);
  ContactAnswer answer;
  answer.header = message.header;
  answer.status = message.status;
  answer.reason = message.status_text;
  answer.x = message.wheelset.position.x;
  answer.pose = {result.y, result.z, result.yaw, result.roll};
  answer.result = isUsable(result.status) ? &result : nullptr;
  return answer;
}
}  // namespace wheel_rail_contact
