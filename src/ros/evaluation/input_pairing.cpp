// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/input_pairing.h"

#include <boost/make_shared.hpp>

#include "config/text.h"

namespace wheel_rail_contact
{
namespace
{
/// The message to store: with a frame_id that is cut at the longest stored length.
template <typename Message>
boost::shared_ptr<const Message> kept(const boost::shared_ptr<const Message>& message)
{
  if (message->header.frame_id.size() <= InputPairing::longest_frame_name)
  {
    return message;
  }
  auto shortened = boost::make_shared<Message>(*message);
  shortened->header.frame_id = message->header.frame_id.substr(0, InputPairing::longest_frame_name) + "...";
  return shortened;
}

void put(InputTopic topic, const InputMessage& message, ContactInput& input)
{
  const auto put_as = [&](InputTopic own, auto& member)
  {
    if (topic == own)
    {
      member = std::get<std::decay_t<decltype(member)>>(message);
    }
  };
  put_as(InputTopic::pose, input.pose);
  put_as(InputTopic::load, input.load);
  put_as(InputTopic::left_rail_force, input.rail_force.left);
  put_as(InputTopic::right_rail_force, input.rail_force.right);
  put_as(InputTopic::rail_displacement, input.rail_displacement);
  put_as(InputTopic::distance, input.distance);
  put_as(InputTopic::twist, input.twist);
}

/// Topics that are paired, in the order of the channels: a load that is interpolated is the last one.
std::vector<InputTopic> channelsOf(const NodeConfig& config)
{
  std::vector<InputTopic> topics = inputTopics(config);
  const auto load = std::find(topics.begin(), topics.end(), InputTopic::load);
  if (config.interpolate_load && load != topics.end())
  {
    std::rotate(load, load + 1, topics.end());
  }
  return topics;
}

bool interpolatesLoad(const NodeConfig& config)
{
  return config.interpolate_load && config.model.wheelset.solve_height_and_roll;
}

void interpolate(const geometry_msgs::Vector3& after, double share, geometry_msgs::Vector3& value)
{
  value.x += share * (after.x - value.x);
  value.y += share * (after.y - value.y);
  value.z += share * (after.z - value.z);
}

void putInterpolatedLoad(const InputMessage& before, const InputMessage& after, ContactInput& input)
{
  const auto &one = *std::get<geometry_msgs::WrenchStampedConstPtr>(before),
             &other = *std::get<geometry_msgs::WrenchStampedConstPtr>(after);
  input.fault = interpolationFault(one, other);
  input.load = boost::make_shared<geometry_msgs::WrenchStamped>(interpolatedLoad(one, other, input.pose->header.stamp));
}
}  // namespace

geometry_msgs::WrenchStamped interpolatedLoad(const geometry_msgs::WrenchStamped& before,
                                              const geometry_msgs::WrenchStamped& after, const ros::Time& stamp)
{
  geometry_msgs::WrenchStamped load = after;
  load.header.stamp = stamp;
  if (after.header.stamp == before.header.stamp)
  {
    return load;
  }
  const double share = (stamp - before.header.stamp).toSec() / (after.header.stamp - before.header.stamp).toSec();
  load.wrench = before.wrench;
  interpolate(after.wrench.force, share, load.wrench.force);
  interpolate(after.wrench.torque, share, load.wrench.torque);
  return load;
}

std::string interpolationFault(const geometry_msgs::WrenchStamped& before, const geometry_msgs::WrenchStamped& after)
{
  if (before.header.frame_id == after.header.frame_id)
  {
    return "";
  }
  return formatted(
      "load: frame_id is '%.60s' before the pose and '%.60s' after it, but must be the same to interpolate",
      before.header.frame_id.c_str(), after.header.frame_id.c_str());
}

InputPairing::InputPairing(const NodeConfig& config)
    : interpolates_(interpolatesLoad(config)),
      topics_(channelsOf(config)),
      pairing_(topics_.size(), config.slop, capacity,
               interpolates_ ? std::optional<double>(config.longest_gap) : std::nullopt)
{
}

std::vector<ContactInput> InputPairing::add(InputTopic topic, const InputMessage& message)
{
  std::vector<ContactInput> inputs;
  const auto found = std::find(topics_.begin(), topics_.end(), topic);
  if (found == topics_.end())
  {
    return inputs;
  }
  const ros::Time stamp = std::visit([](const auto& m) { return m->header.stamp; }, message);
  for (const auto& set : pairing_.add(static_cast<std::size_t>(found - topics_.begin()), stamp,
                                      std::visit([](const auto& m) { return InputMessage(kept(m)); }, message)))
  {
    inputs.push_back(inputOf(set));
  }
  return inputs;
}

ContactInput InputPairing::inputOf(const std::vector<InputMessage>& set) const
{
  ContactInput input;
  for (std::size_t channel = 0; channel < topics_.size(); ++channel)
  {
    put(topics_[channel], set[channel], input);
  }
  if (interpolates_)
  {
    putInterpolatedLoad(set[set.size() - 2], set.back(), input);
  }
  return input;
}
}  // namespace wheel_rail_contact
