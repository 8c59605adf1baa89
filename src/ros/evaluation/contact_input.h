// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <tf2/buffer_core.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include <wheel_rail_contact/WheelsetContact.h>
#include "ros/evaluation/reset_rule.h"
#include "ros/evaluation/stamp_pairing.h"
#include "ros/parameters/parameters.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// Messages that belong to one instant: one of each input topic.
struct ContactInput
{
  geometry_msgs::PoseStampedConstPtr pose;    ///< never null
  geometry_msgs::WrenchStampedConstPtr load;  ///< null if height and roll are given
  /// By Side; null unless rail_bending/lateral_force is `topic`.
  std::array<geometry_msgs::WrenchStampedConstPtr, 2> rail_force;
  ros::WallTime arrival;  ///< time at which the last message arrived at the live node; not set in a replay
};

/// Pairs the messages of the input topics by stamp. The configuration determines the topics: always the pose; the load
/// unless height and roll are given with the pose; the rail forces if rail_bending/lateral_force is `topic`.
class InputPairing
{
 public:
  /// Largest number of messages of one topic that wait for a match.
  static constexpr std::size_t capacity = 1000;
  /// Longest frame_id that is stored [bytes]; longer ones are cut, so that waiting messages take bounded memory.
  static constexpr std::size_t longest_frame_name = 1000;

  /// Keeps no reference to `config`.
  explicit InputPairing(const NodeConfig& config);

  /// True if the load is an input topic.
  bool usesLoad() const { return uses_load_; }
  /// True if the rail forces are input topics.
  bool usesRailForces() const { return uses_rail_forces_; }

  /// Adds a pose. @return the input that it completes, if any.
  std::optional<ContactInput> addPose(const geometry_msgs::PoseStampedConstPtr& pose);
  /// Adds a load; ignored unless usesLoad(). @return the input that it completes, if any.
  std::optional<ContactInput> addLoad(const geometry_msgs::WrenchStampedConstPtr& load);
  /// Adds the force on a rail; ignored unless usesRailForces(). @return the input that it completes, if any.
  std::optional<ContactInput> addRailForce(core::Side side, const geometry_msgs::WrenchStampedConstPtr& force);

  /// Drops all waiting messages, at the end of a recording.
  void finish() { pairing_.finish(); }
  /// Numbers of messages received, paired, dropped and waiting.
  const PairingCounts& counts() const { return pairing_.counts(); }
  /// True if no message waits, and no topic has gone back in time before the others.
  bool isSettled() const { return pairing_.isSettled(); }

 private:
  struct Sample
  {
    geometry_msgs::PoseStampedConstPtr pose;
    geometry_msgs::WrenchStampedConstPtr wrench;
  };
  std::optional<ContactInput> add(std::size_t channel, const ros::Time& stamp, Sample sample);
  std::size_t firstRailForceChannel() const { return uses_load_ ? 2 : 1; }

  bool uses_load_;
  bool uses_rail_forces_;
  StampPairing<Sample> pairing_;
};

/// Exception for an input that cannot be evaluated: status constant of the message WheelsetContact, and the reason.
class UnusableInput : public std::runtime_error
{
 public:
  /// @param reason text for status_text
  UnusableInput(std::uint8_t status, const std::string& reason) : std::runtime_error(reason), status_(status) {}
  /// INVALID_INPUT or NO_TRANSFORM.
  std::uint8_t status() const { return status_; }

 private:
  std::uint8_t status_;
};

/// True for a valid tf frame name: not empty, without a leading slash.
bool isFrameName(const std::string& name);

/// State of the wheelset in the track frame, for the core.
///
/// Pose: in the track frame, or in a frame that tf can transform to the track frame at the stamp of the pose. The
/// length of the quaternion must be 1 within 1e-3; it is normalised. The rotation about the axle is ignored
/// (toWheelsetPose()).
///
/// Load: force and moment on the axle centre in track axes; frame_id must be empty or the track frame.
///
/// Rail forces: force.y is Y, positive outward on both rails (side axes; frame_id is not used).
///
/// @throw UnusableInput with INVALID_INPUT for a number that is not finite, an invalid quaternion, or a load in another
/// frame; with NO_TRANSFORM if tf has no transform from the frame of the pose to the track frame.
core::WheelsetState toState(const ContactInput& input, const std::string& track_frame,
                            const tf2::BufferCore& transforms);

/// Input of an evaluation: the state, or the reason why the input is unusable.
struct PreparedInput
{
  ros::Time stamp;                            ///< of the pose
  core::WheelsetState state;                  ///< valid only with status OK
  std::uint8_t status = WheelsetContact::OK;  ///< OK, INVALID_INPUT or NO_TRANSFORM
  std::string reason;                         ///< empty with status OK
  bool resets = true;                         ///< warm-start reset before this input (ResetRule)
  bool lacks_neighbour = false;               ///< the forces of a neighbour are unknown and taken as zero
};

/// Prepares the inputs of one wheelset, in order, for evaluation.
class InputPreparation
{
 public:
  /// Longest time that an input waits for its transform, from its arrival [s].
  static constexpr double transform_timeout = 0.1;

  /// Keeps no reference to `config`.
  explicit InputPreparation(const NodeConfig& config) : track_frame_(config.track_frame) {}

  /// True if the input need not wait: its pose needs no transform, its frame_id is invalid, or tf has the transform.
  bool isReady(const ContactInput& input, const tf2::BufferCore& transforms) const;
  /// Does not throw for an unusable input: see PreparedInput::status.
  PreparedInput prepare(const ContactInput& input, const tf2::BufferCore& transforms);

 private:
  std::string track_frame_;
  ResetRule reset_rule_;
};
}  // namespace wheel_rail_contact
