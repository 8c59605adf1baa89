// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/message_reply.h"

#include <array>
#include <cmath>
#include <utility>

namespace simulate_wheelset
{
namespace
{
using wheel_rail_contact::ContactPatch;
using wheel_rail_contact::WheelsetContact;

constexpr std::int64_t first_stamp = 1'000'000'000'000;  ///< [ns]

std::string nameOf(std::uint8_t status)
{
  const std::array<std::pair<std::uint8_t, const char*>, 8> names = {{{WheelsetContact::OK, "OK"},
                                                                      {WheelsetContact::LIFT_OFF, "LIFT_OFF"},
                                                                      {WheelsetContact::OFF_PROFILE, "OFF_PROFILE"},
                                                                      {WheelsetContact::NOT_CONVERGED, "NOT_CONVERGED"},
                                                                      {WheelsetContact::INVALID_INPUT, "INVALID_INPUT"},
                                                                      {WheelsetContact::NO_TRANSFORM, "NO_TRANSFORM"},
                                                                      {WheelsetContact::OUTSIDE_LINE, "OUTSIDE_LINE"},
                                                                      {WheelsetContact::TOO_DEEP, "TOO_DEEP"}}};
  for (const auto& [value, name] : names)
  {
    if (value == status)
    {
      return name;
    }
  }
  return "status " + std::to_string(status);
}

/// Rotation about x of a pose that is rotated about x and z only [rad].
double rollOf(const geometry_msgs::Quaternion& q)
{
  return std::atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y));
}

ContactPoint pointOf(const ContactPatch& patch, const geometry_msgs::Point& centre)
{
  ContactPoint point;
  point.is_left = patch.side == ContactPatch::LEFT;
  const geometry_msgs::Point& position = patch.pose.position;
  point.position = {position.x - centre.x, position.y - centre.y, position.z - centre.z};
  point.angle = rollOf(patch.pose.orientation);
  point.normal_force = patch.normal_force;
  point.semi_axis_along = patch.semi_axis_along;
  point.semi_axis_across = patch.semi_axis_across;
  point.rolling_radius = patch.rolling_radius;
  return point;
}
}  // namespace

ros::Time stampOf(std::int64_t time)
{
  ros::Time stamp;
  return stamp.fromNSec(static_cast<std::uint64_t>(first_stamp + time));
}

geometry_msgs::PoseStamped poseMessage(const ContactRequest& request, const std::string& frame)
{
  geometry_msgs::PoseStamped message;
  message.header.stamp = stampOf(request.time);
  message.header.frame_id = frame;
  message.pose.position.x = request.distance;
  message.pose.position.y = request.y;
  message.pose.orientation.z = std::sin(0.5 * request.yaw);
  message.pose.orientation.w = std::cos(0.5 * request.yaw);
  return message;
}

geometry_msgs::WrenchStamped loadMessage(const ContactRequest& request, const std::string& frame)
{
  geometry_msgs::WrenchStamped message;
  message.header.stamp = stampOf(request.time);
  message.header.frame_id = frame;
  message.wrench.force.z = request.force_z;
  message.wrench.torque.x = request.torque_x;
  return message;
}

ContactReply replyOf(const WheelsetContact& message)
{
  ContactReply reply;
  reply.is_usable = message.status == WheelsetContact::OK || message.status == WheelsetContact::LIFT_OFF;
  reply.status = statusText(nameOf(message.status), message.status_text);
  reply.z = message.wheelset.position.z;
  reply.roll = rollOf(message.wheelset.orientation);
  for (const ContactPatch& patch : message.patches)
  {
    reply.points.push_back(pointOf(patch, message.wheelset.position));
  }
  return reply;
}
}  // namespace simulate_wheelset
