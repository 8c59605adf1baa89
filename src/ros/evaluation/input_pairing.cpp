// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/input_pairing.h"

#include <algorithm>
#include <boost/make_shared.hpp>

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
  switch (topic)
  {
    case InputTopic::pose:
      input.pose = std::get<geometry_msgs::PoseStampedConstPtr>(message);
      break;
    case InputTopic::load:
      input.load = std::get<geometry_msgs::WrenchStampedConstPtr>(message);
      break;
    case InputTopic::left_rail_force:
      input.rail_force[0] = std::get<geometry_msgs::WrenchStampedConstPtr>(message);
      break;
    case InputTopic::right_rail_force:
      input.rail_force[1] = std::get<geometry_msgs::WrenchStampedConstPtr>(message);
      break;
    case InputTopic::rail_displacement:
      input.rail_displacement = std::get<RailDisplacementsConstPtr>(message);
      break;
    case InputTopic::distance:
      input.distance = std::get<geometry_msgs::PointStampedConstPtr>(message);
      break;
  }
}
}  // namespace

InputPairing::InputPairing(const NodeConfig& config)
    : topics_(inputTopics(config)), pairing_(topics_.size(), config.slop, capacity)
{
}

std::optional<ContactInput> InputPairing::add(InputTopic topic, const InputMessage& message)
{
  const auto found = std::find(topics_.begin(), topics_.end(), topic);
  if (found == topics_.end())
  {
    return std::nullopt;
  }
  const ros::Time stamp = std::visit([](const auto& m) { return m->header.stamp; }, message);
  const auto set = pairing_.add(static_cast<std::size_t>(found - topics_.begin()), stamp,
                                std::visit([](const auto& m) { return InputMessage(kept(m)); }, message));
  if (!set)
  {
    return std::nullopt;
  }
  ContactInput input;
  for (std::size_t channel = 0; channel < topics_.size(); ++channel)
  {
    put(topics_[channel], (*set)[channel], input);
  }
  return input;
}
}  // namespace wheel_rail_contact
