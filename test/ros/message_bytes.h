// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialization.h>

#include "../usual_headers.h"

namespace wheel_rail_contact
{
/// A message in the form in which it is sent. Tests compare messages by it, because the messages of Ubuntu's own ROS
/// packages have no operator==.
template <typename Message>
std::vector<std::uint8_t> bytesOf(const Message& message)
{
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, message);
  return bytes;
}
}  // namespace wheel_rail_contact
