// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/time.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <string>

#include <wheel_rail_contact/WheelsetContact.h>

namespace wheel_rail_contact
{
/// First fields of a message WheelsetContact, read without the patches. These may be large, or of a wrong size in a
/// damaged message.
struct ResultHead
{
  ros::Time stamp;                            ///< of the header
  std::uint8_t status = WheelsetContact::OK;  ///< constant of the message WheelsetContact
  std::string status_text;
  bool held = false;
  RailDeflection left_rail, right_rail;
};
}  // namespace wheel_rail_contact

namespace ros
{
namespace message_traits
{
/// Same as for WheelsetContact.
template <>
struct MD5Sum<wheel_rail_contact::ResultHead> : MD5Sum<wheel_rail_contact::WheelsetContact>
{
};
/// Same as for WheelsetContact.
template <>
struct DataType<wheel_rail_contact::ResultHead> : DataType<wheel_rail_contact::WheelsetContact>
{
};
}  // namespace message_traits

namespace serialization
{
/// Reads the fields in the order of WheelsetContact.msg.
template <>
struct Serializer<wheel_rail_contact::ResultHead>
{
  /// @throw StreamOverrunException if the message ends before its patches.
  template <typename Stream>
  static void read(Stream& stream, wheel_rail_contact::ResultHead& result)
  {
    std_msgs::Header header;
    geometry_msgs::Pose wheelset;
    double distance = 0, speed = 0, rotation = 0;
    wheel_rail_contact::WheelForces left_wheel, right_wheel;
    geometry_msgs::Wrench rail_wrench;
    stream.next(header);
    stream.next(result.status);
    stream.next(result.status_text);
    stream.next(result.held);
    stream.next(wheelset);
    stream.next(distance);
    stream.next(left_wheel);
    stream.next(right_wheel);
    stream.next(rail_wrench);
    stream.next(speed);
    stream.next(rotation);
    stream.next(result.left_rail);
    stream.next(result.right_rail);
    result.stamp = header.stamp;
  }
};
}  // namespace serialization
}  // namespace ros
