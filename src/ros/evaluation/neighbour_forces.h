// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Pose.h>
#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/time.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <wheel_rail_contact/WheelsetContact.h>
#include "config/node_config.h"
#include "core/rail/neighbours.h"

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

namespace wheel_rail_contact
{
/// Effect of the neighbouring wheelsets on the rails at a stamp.
struct NeighbourEffect
{
  core::Sides<core::RailDeflection> deflection;  ///< of each rail by Side; side axes
  bool complete = true;                          ///< the forces of all neighbours are known
};

/// Rail forces of the neighbouring wheelsets (rail_bending/neighbours), from their results.
///
/// For an input with stamp t, the newest result of each neighbour with a stamp before t is used, never one at t itself.
/// The order in which two wheelsets are evaluated in one time step therefore has no effect. The forces are unknown, and
/// taken as zero, if this result is not usable, is older than `longest_age`, or does not exist. If the stamps of a
/// neighbour go back to t, its results at and after t are discarded. Thread-safe.
class NeighbourForces
{
 public:
  static constexpr double longest_age = 1.0;     ///< largest difference of the stamps at which a result is used [s]
  static constexpr std::size_t capacity = 1000;  ///< largest number of stored results of each neighbour

  /// Keeps no reference to `config`.
  explicit NeighbourForces(const NodeConfig& config);

  /// Adds a result of a neighbour.
  /// @param neighbour index in NodeConfig::neighbours
  void add(std::size_t neighbour, const ResultHead& result);

  /// True if each neighbour has a stored result at least `longest_age` before the stamp. Earlier results then have no
  /// effect at this stamp or a later one.
  bool reachBackFrom(const ros::Time& stamp) const;

  /// Effect of all neighbours at the stamp.
  NeighbourEffect effectAt(const ros::Time& stamp) const;

 private:
  using Forces = core::Sides<core::RailForce>;  ///< by Side
  struct Result
  {
    ros::Time stamp;
    std::optional<Forces> forces;  ///< empty unless the result is usable and the forces are finite
  };
  struct Neighbour
  {
    core::Sides<core::ComplianceTable> influence;
    std::deque<Result> results;  ///< in order of increasing stamps
  };
  static const Forces* forcesAt(const Neighbour& neighbour, const ros::Time& stamp);
  static std::optional<Forces> forcesOf(const ResultHead& result);

  core::Sides<double> inclination_;  ///< of the rails [rad]
  mutable std::mutex mutex_;         ///< guards `neighbours_`
  std::vector<Neighbour> neighbours_;
};
}  // namespace wheel_rail_contact
