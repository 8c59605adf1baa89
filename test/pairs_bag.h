// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/serialization.h>

#include <cstdint>
#include <string>
#include <vector>

#include "bag/bag_writer.h"

namespace wheel_rail_contact
{
template <typename Message>
std::string bytesOfMessage(const Message& message)
{
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return {bytes.begin(), bytes.end()};
}

template <typename Message>
std::uint32_t addTopic(const std::string& topic, BagWriter& bag)
{
  BagConnection connection;
  connection.topic = topic;
  connection.header.set("topic", topic)
      .set("type", ros::message_traits::datatype<Message>())
      .set("md5sum", ros::message_traits::md5sum<Message>())
      .set("message_definition", ros::message_traits::definition<Message>());
  return bag.addConnection(connection);
}

/// Stamp of a pair in the bag of writePairs(): 1000 of them per second.
inline ros::Time stampOf(int pair)
{
  return ros::Time(static_cast<std::uint32_t>(1 + pair / 1000), static_cast<std::uint32_t>(pair % 1000) * 1000000U);
}

/// A bag of a wheelset with 100 kN on each wheel that is at `lateral(i)` [m] in pair i.
template <typename Lateral>
void writePairs(const std::string& path, int pairs, Lateral lateral)
{
  BagWriter bag(path, "none");
  const auto pose_topic = addTopic<geometry_msgs::PoseStamped>("/wheelset/pose", bag);
  const auto load_topic = addTopic<geometry_msgs::WrenchStamped>("/wheelset/load", bag);
  geometry_msgs::PoseStamped pose;
  geometry_msgs::WrenchStamped load;
  pose.header.frame_id = "track";
  pose.pose.orientation.w = 1;
  load.wrench.force.z = -200e3;  // [N]
  for (int i = 0; i < pairs; ++i)
  {
    pose.header.stamp = load.header.stamp = stampOf(i);
    pose.pose.position.y = lateral(i);
    bag.write(pose_topic, pose.header.stamp.toNSec(), bytesOfMessage(pose));
    bag.write(load_topic, load.header.stamp.toNSec(), bytesOfMessage(load));
  }
  bag.close();
}
}  // namespace wheel_rail_contact
