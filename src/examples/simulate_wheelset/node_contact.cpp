// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/node_contact.h"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/names.h>
#include <ros/param.h>
#include <wheel_rail_contact/EvaluateWheelset.h>
#include <wheel_rail_contact/WheelsetContact.h>

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "examples/simulate_wheelset/contact_source.h"
#include "wheel_rail_contact/core/track.h"

namespace simulate_wheelset
{
namespace
{
using wheel_rail_contact::ContactPatch;
using wheel_rail_contact::EvaluateWheelset;
using wheel_rail_contact::WheelsetContact;

constexpr std::int64_t first_stamp = 1'000'000'000'000;  ///< [ns]
constexpr double service_wait = 60;                      ///< longest one, for the service [s]
constexpr std::uint32_t queue_size = 1;                  // in lockstep no second message waits
constexpr double result_wait = 10;        ///< longest one, for a result [s]; builds with sanitizers are slow
constexpr double attempt_duration = 0.1;  ///< between attempts to reach the node [s]
constexpr int attempts = 600;
constexpr double trial_force_z = -100e3;              ///< a light wheelset [N]; the result of the trial is not used
constexpr std::int64_t attempt_time = 1'000'000'000;  ///< between the stamps of attempts [ns]

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
  copySizes(patch, point);
  return point;
}

/// Stamp of a time since the start [ns]. Stamps begin at 1000 s: messages with a stamp of 0 are dropped, and the trial
/// states of TopicContact have stamps before the start.
ros::Time stampOf(std::int64_t time)
{
  ros::Time stamp;
  return stamp.fromNSec(static_cast<std::uint64_t>(first_stamp + time));
}

/// Pose of the axle in the track frame. Height and roll are zero: they are results.
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

/// Load on the axle centre, in track axes.
geometry_msgs::WrenchStamped loadMessage(const ContactRequest& request, const std::string& frame)
{
  geometry_msgs::WrenchStamped message;
  message.header.stamp = stampOf(request.time);
  message.header.frame_id = frame;
  message.wrench.force.z = request.force_z;
  message.wrench.torque.x = request.torque_x;
  return message;
}

/// The reply in a message of the contact node.
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

std::string fullName(const std::string& node, const std::string& parameter)
{
  return ros::names::resolve(node) + "/" + parameter;
}

/// A radius on the parameter server; `otherwise` if it has none [m].
double radius(const std::string& name, double otherwise)
{
  double value = otherwise;
  std::string text;  // 460e-3 in a YAML file is a text for the parameter server, and a number for the node
  if (ros::param::get(name, text))
  {
    std::istringstream(text) >> value;
  }
  else if (!ros::param::get(name, value) && ros::param::has(name))
  {
    value = 0;
  }
  if (!(value > 0))
  {
    throw std::runtime_error(name + " must be a number > 0");
  }
  return value;
}
}  // namespace

void requireWheelLoads(const std::string& node)
{
  const std::string balance = fullName(node, "wheelset/balance"), expected = "wheel_loads";
  const std::string value = ros::param::param(balance, expected);
  if (value != expected)
  {
    throw std::runtime_error(balance + " = " + value + " must be " + expected + ": the load of this program is for it");
  }
  const std::string free = fullName(node, "wheelset/free");
  std::vector<std::string> solved;
  if (ros::param::get(free, solved) && solved.empty())
  {
    throw std::runtime_error(free + " = [] must be [z, roll]: this program does not integrate height and roll");
  }
}

double rollingRadiusOf(const std::string& node)
{
  const double of_both =
      radius(fullName(node, "wheelset/rolling_radius"), wheel_rail_contact::core::WheelsetConfig().meanRadius());
  return 0.5 * (radius(fullName(node, "wheel/left/rolling_radius"), of_both) +
                radius(fullName(node, "wheel/right/rolling_radius"), of_both));
}

ServiceContact::ServiceContact(const std::string& node, std::string frame)
    : frame_(std::move(frame)), rolling_radius_(rollingRadiusOf(node))
{
  const std::string service = nh_.resolveName(node + "/evaluate");
  if (!ros::service::waitForService(service, ros::Duration(service_wait)))
  {
    throw std::runtime_error("no service " + service + " within a minute");
  }
  requireWheelLoads(node);
  // A persistent client connects when it is made: the service must exist.
  client_ = nh_.serviceClient<EvaluateWheelset>(service, true);
}

ContactReply ServiceContact::evaluate(const ContactRequest& request)
{
  EvaluateWheelset call;
  call.request.pose = poseMessage(request, frame_);
  call.request.load = loadMessage(request, frame_);
  if (!client_.call(call))
  {
    throw std::runtime_error("the call of " + client_.getService() + " failed");
  }
  return replyOf(call.response.contact);
}

TopicContact::TopicContact(const std::string& node, std::string frame)
    : frame_(std::move(frame)), rolling_radius_(rollingRadiusOf(node))
{
  requireWheelLoads(node);
  nh_.setCallbackQueue(&queue_);
  pose_publisher_ = nh_.advertise<geometry_msgs::PoseStamped>("wheelset/pose", queue_size);
  load_publisher_ = nh_.advertise<geometry_msgs::WrenchStamped>("wheelset/load", queue_size);
  subscriber_ = nh_.subscribe<wheel_rail_contact::WheelsetContact>(
      node + "/contact", queue_size,
      [this](const wheel_rail_contact::WheelsetContact::ConstPtr& message) { latest_ = message; }, ros::VoidConstPtr(),
      ros::TransportHints().tcpNoDelay());
  // Messages are lost until all connections exist. Trial states are sent until the first result, with stamps before the
  // start.
  ContactRequest trial;
  trial.force_z = trial_force_z;
  for (int i = 0; i < attempts; ++i)
  {
    trial.time = (i - attempts) * attempt_time;
    send(trial);
    if (waitFor(stampOf(trial.time), attempt_duration))
    {
      return;
    }
  }
  throw std::runtime_error("no result on " + subscriber_.getTopic() + " within a minute");
}

ContactReply TopicContact::evaluate(const ContactRequest& request)
{
  send(request);
  if (!waitFor(stampOf(request.time), result_wait))
  {
    throw std::runtime_error("no result on " + subscriber_.getTopic() + " within 10 s");
  }
  return replyOf(*latest_);
}

void TopicContact::send(const ContactRequest& request)
{
  pose_publisher_.publish(poseMessage(request, frame_));
  load_publisher_.publish(loadMessage(request, frame_));
}

bool TopicContact::waitFor(const ros::Time& stamp, double seconds)
{
  const auto is_here = [&] { return latest_ && latest_->header.stamp == stamp; };
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!is_here() && ros::ok() && ros::WallTime::now() < end)
  {
    queue_.callAvailable(ros::WallDuration(0.01));
  }
  return is_here();
}
}  // namespace simulate_wheelset
