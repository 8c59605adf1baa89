// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

#include <wheel_rail_contact/RailDisplacements.h>
#include "config/node_config.h"

namespace wheel_rail_contact
{
/// Input topic of a wheelset.
enum class InputTopic
{
  pose,               ///< wheelset/pose (PoseStamped); always required
  load,               ///< wheelset/load (WrenchStamped), unless height and roll are given
  left_rail_force,    ///< wheelset/left_rail_force (WrenchStamped), if rail_bending/lateral_force is `topic`
  right_rail_force,   ///< wheelset/right_rail_force (WrenchStamped), the same
  rail_displacement,  ///< wheelset/rail_displacement (RailDisplacements), if track/displacement is `topic`
  distance,           ///< wheelset/distance (PointStamped), if track/distance is `topic`
  twist               ///< wheelset/twist (TwistStamped), unless creep/method is `none`
};

/// All input topics.
inline constexpr std::array<InputTopic, 7> all_input_topics{InputTopic::pose,
                                                            InputTopic::load,
                                                            InputTopic::left_rail_force,
                                                            InputTopic::right_rail_force,
                                                            InputTopic::rail_displacement,
                                                            InputTopic::distance,
                                                            InputTopic::twist};

/// Message of any input topic; never null.
using InputMessage =
    std::variant<geometry_msgs::PoseStampedConstPtr, geometry_msgs::WrenchStampedConstPtr, RailDisplacementsConstPtr,
                 geometry_msgs::PointStampedConstPtr, geometry_msgs::TwistStampedConstPtr>;

/// Input topics that a configuration requires.
std::vector<InputTopic> inputTopics(const NodeConfig& config);

/// Name of a topic in the namespace of the wheelset, for example "wheelset/pose".
std::string nameOf(InputTopic topic);

/// Stands for a type of messages, as the argument of a function.
template <typename Type>
struct MessageType
{
  using Message = Type;
};

/// Calls a function with the MessageType of a topic.
/// @return the value of the function, whose type must not depend on that of the messages
template <typename Function>
auto withMessageType(InputTopic topic, const Function& function)
{
  switch (topic)
  {
    case InputTopic::pose:
      return function(MessageType<geometry_msgs::PoseStamped>());
    case InputTopic::rail_displacement:
      return function(MessageType<RailDisplacements>());
    case InputTopic::distance:
      return function(MessageType<geometry_msgs::PointStamped>());
    case InputTopic::twist:
      return function(MessageType<geometry_msgs::TwistStamped>());
    default:
      return function(MessageType<geometry_msgs::WrenchStamped>());
  }
}
}  // namespace wheel_rail_contact
