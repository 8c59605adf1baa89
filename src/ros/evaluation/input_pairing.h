// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "ros/evaluation/input_topic.h"
#include "ros/evaluation/stamp_pairing.h"

namespace wheel_rail_contact
{
/// Messages that belong to one instant: one of each input topic (inputTopics()). The others are null.
struct ContactInput
{
  geometry_msgs::PoseStampedConstPtr pose;                         ///< never null
  geometry_msgs::WrenchStampedConstPtr load;                       ///< on the axle centre
  std::array<geometry_msgs::WrenchStampedConstPtr, 2> rail_force;  ///< by Side
  RailDisplacementsConstPtr rail_displacement;                     ///< of both rails
  geometry_msgs::PointStampedConstPtr distance;                    ///< place along the line
  ros::WallTime arrival;  ///< time at which the last message arrived at the live node; not set in a replay
};

/// Pairs the messages of the input topics by stamp.
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
  /// @return the input that it completes, if any.
  std::optional<ContactInput> add(InputTopic topic, const InputMessage& message);

  /// Drops all waiting messages, at the end of a recording.
  void finish() { pairing_.finish(); }
  /// Numbers of messages received, paired, dropped and waiting.
  const PairingCounts& counts() const { return pairing_.counts(); }
  /// True if no message waits, and no topic has gone back in time before the others.
  bool isSettled() const { return pairing_.isSettled(); }

 private:
  std::vector<InputTopic> topics_;      ///< topic of each channel
  StampPairing<InputMessage> pairing_;  ///< a channel for each topic
};
}  // namespace wheel_rail_contact
