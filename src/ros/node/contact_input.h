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
#include "ros/node/reset_rule.h"
#include "ros/node/stamp_pairing.h"
#include "ros/parameters/parameters.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// The messages that belong to one instant.
struct ContactInput
{
  geometry_msgs::PoseStampedConstPtr pose;    ///< never null
  geometry_msgs::WrenchStampedConstPtr load;  ///< null if height and roll are given
  /// By Side; null unless lateral forces come by topic.
  std::array<geometry_msgs::WrenchStampedConstPtr, 2> rail_force;
  ros::WallTime arrival;  ///< of the last of them at a live node; not set otherwise
};

/// Pairs the messages of the input topics. Which topics take part follows from the configuration: the pose always, the
/// load unless height and roll are given with the pose, the rail forces if rail_bending/lateral_force is `topic`.
class InputPairing
{
 public:
  /// Greatest number of messages of one topic that wait for their partners.
  static constexpr std::size_t capacity = 1000;
  /// Longest name of a frame that is kept; longer ones, which no frame has, are cut.
  static constexpr std::size_t longest_frame_name = 1000;

  /// Copies what it needs.
  explicit InputPairing(const NodeConfig& config);

  /// True if the load takes part.
  bool usesLoad() const { return uses_load_; }
  /// True if the rail forces take part.
  bool usesRailForces() const { return uses_rail_forces_; }

  /// Each takes a message. @return the input it completes, if any.
  std::optional<ContactInput> addPose(const geometry_msgs::PoseStampedConstPtr& pose);
  /// Likewise; ignored unless usesLoad().
  std::optional<ContactInput> addLoad(const geometry_msgs::WrenchStampedConstPtr& load);
  /// Likewise; ignored unless usesRailForces().
  std::optional<ContactInput> addRailForce(core::Side side, const geometry_msgs::WrenchStampedConstPtr& force);

  /// Drops what still waits, at the end of a recording.
  void finish() { pairing_.finish(); }
  /// Where the messages went so far.
  const PairingCounts& counts() const { return pairing_.counts(); }
  /// True if nothing waits for its partners.
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

/// An input that cannot be evaluated: status constant of the message WheelsetContact, and the reason.
class UnusableInput : public std::runtime_error
{
 public:
  /// `reason`: a sentence for people.
  UnusableInput(std::uint8_t status, const std::string& reason) : std::runtime_error(reason), status_(status) {}
  /// INVALID_INPUT or NO_TRANSFORM.
  std::uint8_t status() const { return status_; }

 private:
  std::uint8_t status_;
};

/// True if tf can know a frame of this name: not empty, without a slash before it.
bool isFrameName(const std::string& name);

/// Brings an input to the track frame and to the core's terms.
///
/// Pose: in the track frame, or in a frame from which tf leads there at the pose's stamp. A quaternion within 1e-3 of
/// unit length is normalised; rotation about the axle does not count (toWheelsetPose()).
///
/// Load: force and moment on the axle centre in track axes; its frame_id must be empty or the track frame.
/// Rail forces: force.y is Y, positive outward on either rail (axes of its own side, so the frame_id is not used).
///
/// @throw UnusableInput with INVALID_INPUT for numbers that are not finite, a quaternion that is none, or a load in
/// another frame; with NO_TRANSFORM if tf does not lead from the pose's frame to the track frame.
core::WheelsetState toState(const ContactInput& input, const std::string& track_frame,
                            const tf2::BufferCore& transforms);

/// An input in the core's terms, or the reason why it has none: all that an evaluation needs to know.
struct PreparedInput
{
  ros::Time stamp;                            ///< of the pose
  core::WheelsetState state;                  ///< to evaluate
  std::uint8_t status = WheelsetContact::OK;  ///< INVALID_INPUT or NO_TRANSFORM: `state` means nothing
  std::string reason;                         ///< empty when OK
  bool resets = true;                         ///< forget the answers before (ResetRule)
  bool lacks_neighbour = false;               ///< a neighbour's forces are not known and count as none
};

/// Prepares the inputs of one wheelset in their order.
class InputPreparation
{
 public:
  /// An input that is not ready waits so long for its transform, counted from its arrival [s].
  static constexpr double transform_patience = 0.1;

  /// Copies what it needs.
  explicit InputPreparation(const NodeConfig& config) : track_frame_(config.track_frame) {}

  /// True if nothing speaks against preparing the input at once: it needs no transform, or tf knows it already.
  bool isReady(const ContactInput& input, const tf2::BufferCore& transforms) const;
  /// Never throws for an unusable input: the status tells.
  PreparedInput prepare(const ContactInput& input, const tf2::BufferCore& transforms);

 private:
  std::string track_frame_;
  ResetRule reset_rule_;
};
}  // namespace wheel_rail_contact
