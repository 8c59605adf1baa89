// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ros/evaluation/input_topic.h"
#include "ros/evaluation/stamp_pairing.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact
{
/// Messages that belong to one instant: one of each input topic (inputTopics()). The others are null.
struct ContactInput
{
  geometry_msgs::PoseStampedConstPtr pose;                       ///< never null
  geometry_msgs::WrenchStampedConstPtr load;                     ///< on the axle centre
  core::Sides<geometry_msgs::WrenchStampedConstPtr> rail_force;  ///< by Side
  RailDisplacementsConstPtr rail_displacement;                   ///< of both rails
  geometry_msgs::PointStampedConstPtr distance;                  ///< place along the line
  geometry_msgs::TwistStampedConstPtr twist;                     ///< velocity of the axle centre
  std::string fault;      ///< reason why the messages cannot be used together; empty if there is none
  ros::WallTime arrival;  ///< time at which the last message arrived at the live node; not set in a replay
};

/// Pairs the messages of the input topics by stamp. With NodeConfig::interpolate_load, the load is interpolated at the
/// stamp of the pose.
class InputPairing
{
 public:
  /// Largest number of messages of one topic that wait for a match.
  static constexpr std::size_t capacity = 1000;
  /// Longest frame_id that is stored [bytes]; longer ones are cut, so that waiting messages take bounded memory.
  static constexpr std::size_t longest_frame_name = 1000;

  /// Keeps no reference to `config`.
  explicit InputPairing(const NodeConfig& config);

  /// Adds a message; ignored if the configuration does not require its topic.
  /// @param message of the type of the topic, see withMessageType()
  /// @return the inputs that it completes, in order; more than one only if the load is interpolated.
  std::vector<ContactInput> add(InputTopic topic, const InputMessage& message);

  /// Drops all waiting messages, at the end of a recording.
  void finish() { pairing_.finish(); }
  /// Numbers of messages received, paired, dropped and waiting.
  const PairingCounts& counts() const { return pairing_.counts(); }
  /// Number of poses that were dropped.
  std::uint64_t droppedPoses() const { return pairing_.dropped(0); }
  /// See StampPairing::isSettled().
  bool isSettled() const { return pairing_.isSettled(); }

 private:
  ContactInput inputOf(const std::vector<InputMessage>& set) const;

  bool interpolates_;
  std::vector<InputTopic> topics_;  ///< topic of each channel; the first one is the pose, an interpolated load the last
  StampPairing<InputMessage> pairing_;  ///< a channel for each topic
};

/// Load at a stamp, linear in time between two loads. Force and moment in the axes of the loads [N], [N m].
/// @param before,after loads whose stamps enclose `stamp`, or the same load with this stamp
/// @return the load with the stamp, and with the frame_id of `after`
geometry_msgs::WrenchStamped interpolatedLoad(const geometry_msgs::WrenchStamped& before,
                                              const geometry_msgs::WrenchStamped& after, const ros::Time& stamp);

/// Reason why two loads cannot be interpolated: their frame_id differ. Empty if they are equal.
std::string interpolationFault(const geometry_msgs::WrenchStamped& before, const geometry_msgs::WrenchStamped& after);
}  // namespace wheel_rail_contact
