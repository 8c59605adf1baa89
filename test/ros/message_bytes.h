// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/serialization.h>

#include <wheel_rail_contact/WheelsetContact.h>
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

/// Those of a result but for the wall time, and the number that its publisher gave it.
inline std::vector<std::uint8_t> bytesWithoutTime(WheelsetContact result)
{
  result.solve_time = 0;
  result.header.seq = 0;
  return bytesOf(result);
}
}  // namespace wheel_rail_contact
