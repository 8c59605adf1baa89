// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/in_process_contact.h"

#include <utility>

namespace simulate_wheelset
{
namespace core = wheel_rail_contact::core;

namespace
{
ContactPoint pointOf(const core::PatchResult& patch, const core::WheelsetResult& result)
{
  ContactPoint point;
  point.is_left = patch.side == core::Side::left;
  point.position = {patch.pose.x, patch.pose.y - result.y, patch.pose.z - result.z};
  point.angle = patch.pose.angle;
  copySizes(patch, point);
  return point;
}
}  // namespace

InProcessContact::InProcessContact(core::ContactModelConfig config)
    : rolling_radius_(config.wheelset.meanRadius()), contact_(std::move(config))
{
}

ContactReply InProcessContact::evaluate(const ContactRequest& request)
{
  core::WheelsetState state;
  state.y = request.y;
  state.yaw = request.yaw;
  state.force_z = request.force_z;
  state.torque_x = request.torque_x;
  state.distance = request.distance;
  const core::WheelsetResult& result = contact_.evaluate(state);
  ContactReply reply;
  reply.is_usable = core::isUsable(result.status);
  reply.status = statusText(nameOf(result.status), result.reason);
  reply.z = result.z;
  reply.roll = result.roll;
  for (const core::PatchResult& patch : result.patches)
  {
    reply.points.push_back(pointOf(patch, result));
  }
  return reply;
}
}  // namespace simulate_wheelset
