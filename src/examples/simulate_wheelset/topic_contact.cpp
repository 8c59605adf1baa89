// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/topic_contact.h"

#include <stdexcept>
#include <utility>

#include "examples/simulate_wheelset/message_reply.h"
#include "examples/simulate_wheelset/node_parameters.h"

namespace simulate_wheelset
{
namespace
{
constexpr std::uint32_t queue_size = 1;   // in lockstep no second message waits
constexpr double longest_wait = 10;       ///< for one result [s]; builds with sanitizers are slow
constexpr double attempt_duration = 0.1;  ///< between attempts to reach the node [s]
constexpr int attempts = 600;
constexpr double trial_force_z = -100e3;              ///< a light wheelset [N]; the result of the trial is not used
constexpr std::int64_t attempt_time = 1'000'000'000;  ///< between the stamps of attempts [ns]
}  // namespace

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
  if (!waitFor(stampOf(request.time), longest_wait))
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
