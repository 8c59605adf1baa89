// SPDX-License-Identifier: BSD-3-Clause
// Reads single messages of a bag.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wheel_rail_contact
{
/// A message's type and the checksum of its definition.
template <typename Message>
std::pair<std::string, std::string> typeAndSum()
{
  return {ros::message_traits::datatype<Message>(), ros::message_traits::md5sum<Message>()};
}

/// Calls `read` with a message's stream.
template <typename Read>
void readStream(std::string_view data, const Read& read)
{
  std::vector<std::uint8_t> bytes(data.begin(), data.end());  // the stream asks for data it could change
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  read(stream);
}

/// A message from its bytes.
/// @throw ros::serialization::StreamOverrunException if it is cut off.
template <typename Message>
boost::shared_ptr<Message> parse(std::string_view data)
{
  auto message = boost::make_shared<Message>();
  readStream(data, [&message](auto& stream) { stream.next(*message); });
  return message;
}

/// Those of a message tf2_msgs/TFMessage.
/// @throw ros::serialization::StreamOverrunException if the message is cut off.
std::vector<geometry_msgs::TransformStamped> parseTransforms(std::string_view data);
}  // namespace wheel_rail_contact
