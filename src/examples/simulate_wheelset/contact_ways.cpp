// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/contact_ways.h"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/names.h>
#include <ros/package.h>
#include <ros/param.h>
#include <wheel_rail_contact/EvaluateWheelset.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "wheel_rail_contact/config_file.h"

namespace simulate_wheelset
{
namespace core = wheel_rail_contact::core;

namespace
{
/// @throw Error with this reason if there is a fault.
template <typename Error = std::runtime_error>
void failIf(bool fault, const std::string& reason)
{
  if (fault)
  {
    throw Error(reason);
  }
}

void requireSuitable(const wheel_rail_contact::ContactParameters& parameters)
{
  const core::WheelsetConfig& wheelset = parameters.model.wheelset;
  const core::RailBendingConfig& bending = parameters.model.rail_bending;
  const auto require = [](bool is_suitable, const char* text) { failIf<std::invalid_argument>(!is_suitable, text); };
  require(wheelset.balance == core::WheelsetConfig::Balance::moments,
          "wheelset/balance = wheel_loads must be moments: the load of this program is for it");
  require(parameters.model.creep.method != core::CreepMethod::none,
          "creep/method = none must be linear, fastsim or exact: this program has no friction of its own");
  require(parameters.model.creep.rotation == core::CreepConfig::Rotation::free,
          "creep/rotation = topic must be free: this program does not integrate the rotation");
  require(wheelset.solve_height_and_roll,
          "wheelset/free = [] must be [z, roll]: this program does not integrate height and roll");
  require(!parameters.displacement_topic,
          "track/displacement = topic must be none: this program does not move the rails");
  require(bending.model != core::RailBendingConfig::Model::compliance ||
              bending.lateral_force != core::RailBendingConfig::LateralForce::topic,
          "rail_bending/lateral_force = topic must be contact or a number: this program has no lateral forces");
  require(parameters.neighbours.empty(), "rail_bending/neighbours must be []: this program has one wheelset");
}

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

/// Rotation about x of a pose that is rotated about x and z only [rad].
double rollOf(const geometry_msgs::Quaternion& q)
{
  return std::atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y));
}

core::PatchResult patchOf(const ContactPatch& message)
{
  core::PatchResult patch;
  patch.side = message.side == ContactPatch::LEFT ? core::Side::left : core::Side::right;
  patch.pose.angle = rollOf(message.pose.orientation);
  patch.normal_force = message.normal_force;
  patch.rolling_radius = message.rolling_radius;
  patch.creep.force = {message.creep.force_x, message.creep.force_y, message.creep.moment};
  patch.creep.adhesion_share = message.creep.adhesion_share;
  patch.creep.power = message.creep.power;
  return patch;
}

Eigen::Vector3d toEigen(const geometry_msgs::Vector3& v)
{
  return {v.x, v.y, v.z};
}

/// Stamp of a time since the start [ns]. Stamps begin at 1000 s: messages with a stamp of 0 are dropped, and the trial
/// states of TopicContact have stamps before the start.
ros::Time stampOf(std::int64_t time)
{
  ros::Time stamp;
  return stamp.fromNSec(static_cast<std::uint64_t>(first_stamp + time));
}

/// Pose and velocity of the axle in the track frame, and load on its centre in track axes. Height, roll and rotation
/// are zero: they are results.
EvaluateWheelset::Request messageOf(const ContactRequest& request, const std::string& frame)
{
  EvaluateWheelset::Request message;
  message.pose.header.stamp = stampOf(request.time);
  message.pose.header.frame_id = frame;
  message.pose.pose.position.x = request.state.distance;
  message.pose.pose.position.y = request.state.y;
  message.pose.pose.orientation.z = std::sin(0.5 * request.state.yaw);
  message.pose.pose.orientation.w = std::cos(0.5 * request.state.yaw);
  message.twist.header = message.load.header = message.pose.header;
  message.twist.twist.linear.x = request.state.motion.speed;
  message.twist.twist.linear.y = request.state.motion.lateral_velocity;
  message.twist.twist.angular.z = request.state.motion.yaw_rate;
  message.load.wrench.force.z = request.state.force_z;
  message.load.wrench.torque.x = request.state.torque_x;
  return message;
}

/// The reply in a message of the contact node.
ContactReply replyOf(const WheelsetContact& message)
{
  ContactReply reply;
  reply.status = static_cast<core::ContactStatus>(message.status);
  reply.reason = message.status_text;
  reply.z = message.wheelset.position.z;
  reply.roll = rollOf(message.wheelset.orientation);
  reply.rotation = message.rotation;
  reply.rail_wrench = {toEigen(message.rail_wrench.force), toEigen(message.rail_wrench.torque)};
  reply.rail.left.given.vertical = message.left_rail.given_vertical;
  reply.rail.right.given.vertical = message.right_rail.given_vertical;
  std::transform(message.patches.begin(), message.patches.end(), std::back_inserter(reply.patches), patchOf);
  return reply;
}

std::string fullName(const std::string& node, const std::string& parameter)
{
  return ros::names::resolve(node) + "/" + parameter;
}

}  // namespace

core::ContactModelConfig readContact(const std::string& file)
{
  using wheel_rail_contact::ParameterSource;
  std::vector<ParameterSource> sources{{ParameterSource::file, wheel_rail_contact::default_parameters},
                                       {ParameterSource::file, contact_parameters}};
  if (!file.empty())
  {
    sources.push_back({ParameterSource::file, file});
  }
  wheel_rail_contact::ContactParameters parameters =
      wheel_rail_contact::readContactParameters(sources, {".", ros::package::getPath});
  requireSuitable(parameters);
  return std::move(parameters.model);
}

void requireLoad(const std::string& node)
{
  const std::string balance = fullName(node, "wheelset/balance"), method = fullName(node, "creep/method");
  failIf(ros::param::param<std::string>(balance, "wheel_loads") != "moments",
         balance + " must be moments: the load of this program is for it");
  failIf(ros::param::param<std::string>(method, "none") == "none",
         method + " must be linear, fastsim or exact: this program has no friction of its own");
  const std::string free = fullName(node, "wheelset/free");
  std::vector<std::string> solved;
  failIf(ros::param::get(free, solved) && solved.empty(),
         free + " = [] must be [z, roll]: this program does not integrate height and roll");
}

ServiceContact::ServiceContact(const std::string& node, std::string frame) : frame_(std::move(frame))
{
  const std::string service = nh_.resolveName(node + "/evaluate");
  failIf(!ros::service::waitForService(service, ros::Duration(service_wait)),
         "no service " + service + " within a minute");
  requireLoad(node);
  // A persistent client connects when it is made: the service must exist.
  client_ = nh_.serviceClient<EvaluateWheelset>(service, true);
}

ContactReply ServiceContact::evaluate(const ContactRequest& request)
{
  EvaluateWheelset call;
  call.request = messageOf(request, frame_);
  failIf(!client_.call(call), "the call of " + client_.getService() + " failed");
  return replyOf(call.response.contact);
}

TopicContact::TopicContact(const std::string& node, std::string frame) : frame_(std::move(frame))
{
  requireLoad(node);
  nh_.setCallbackQueue(&queue_);
  pose_publisher_ = nh_.advertise<geometry_msgs::PoseStamped>("wheelset/pose", queue_size);
  twist_publisher_ = nh_.advertise<geometry_msgs::TwistStamped>("wheelset/twist", queue_size);
  load_publisher_ = nh_.advertise<geometry_msgs::WrenchStamped>("wheelset/load", queue_size);
  subscriber_ = nh_.subscribe<wheel_rail_contact::WheelsetContact>(
      node + "/contact", queue_size,
      [this](const wheel_rail_contact::WheelsetContact::ConstPtr& message) { latest_ = message; }, ros::VoidConstPtr(),
      ros::TransportHints().tcpNoDelay());
  // Messages are lost until all connections exist. Trial states are sent until the first result, with stamps before the
  // start.
  ContactRequest trial;
  trial.state.force_z = trial_force_z;
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
  failIf(!waitFor(stampOf(request.time), result_wait), "no result on " + subscriber_.getTopic() + " within 10 s");
  return replyOf(*latest_);
}

void TopicContact::send(const ContactRequest& request)
{
  const EvaluateWheelset::Request message = messageOf(request, frame_);
  latest_.reset();  // that of an earlier request of this step has the same stamp
  pose_publisher_.publish(message.pose);
  twist_publisher_.publish(message.twist);
  load_publisher_.publish(message.load);
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
