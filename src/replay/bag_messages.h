// SPDX-License-Identifier: BSD-3-Clause
// Conversion of single messages of a bag from and to bytes.
#pragma once

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
/// Type of a message and MD5 sum of its definition.
template <typename Message>
std::pair<std::string, std::string> typeAndSum()
{
  return {ros::message_traits::datatype<Message>(), ros::message_traits::md5sum<Message>()};
}

/// Calls `read` with an input stream over the bytes of a message.
template <typename Read>
void readStream(std::string_view data, const Read& read)
{
  std::vector<std::uint8_t> bytes(data.begin(), data.end());  // IStream requires mutable data
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  read(stream);
}

/// Deserialises a message.
/// @throw ros::serialization::StreamOverrunException if the message is truncated.
template <typename Message>
boost::shared_ptr<Message> parse(std::string_view data)
{
  auto message = boost::make_shared<Message>();
  readStream(data, [&message](auto& stream) { stream.next(*message); });
  return message;
}

/// Bytes of a message.
template <typename Message>
std::string serialized(const Message& message)
{
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}
}  // namespace wheel_rail_contact
