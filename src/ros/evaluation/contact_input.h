// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include <wheel_rail_contact/WheelsetContact.h>
#include "config/node_config.h"
#include "ros/evaluation/input_pairing.h"
#include "ros/evaluation/neighbour_forces.h"
#include "ros/evaluation/transform_store.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
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
/// length of the quaternion must be 1 within 1e-3; it is normalised. The rotation about the axle, pitchOf(), matters
/// only for wheels that are not round.
///
/// Load: force and moment on the axle centre in track axes; frame_id must be empty or the track frame.
///
/// Rail forces: force.y is Y, positive outward on both rails (side axes; frame_id is not used).
///
/// Rail displacements and velocities: side axes; frame_id is not used.
///
/// Distance: point.x is the place along the line [m]; frame_id is not used. Without this message it is x of the pose in
/// the track frame.
///
/// Twist: velocity of the axle centre, relative to the track frame; or over ground in the frame of the pose, from which
/// it is turned. In track axes `angular` is roll rate, rotation about the axle and yaw rate: the rotation is along y
/// whatever yaw and roll are.
///
/// @throw UnusableInput with INVALID_INPUT for ContactInput::fault, a number that is not finite, an invalid quaternion,
/// or a load or twist in another frame; with NO_TRANSFORM if tf has no transform from the frame of the pose to the
/// track frame.
///
/// @param fixed_frame  with `path`: a pose that is not in the track frame is transformed to this frame and from there
/// to the track frame in whose cross section it lies; x and the place on the line are that of the cross section.
core::WheelsetState toState(const ContactInput& input, const std::string& track_frame,
                            const tf2::BufferCore& transforms, const std::string& fixed_frame = "",
                            const core::TrackPath* path = nullptr);

/// Input of an evaluation: the state, or the reason why the input is unusable.
struct PreparedInput
{
  ros::Time stamp;                            ///< of the pose
  core::WheelsetState state;                  ///< valid only with status OK
  std::uint8_t status = WheelsetContact::OK;  ///< OK, INVALID_INPUT or NO_TRANSFORM
  std::string reason;                         ///< with status OK a warning, or empty
  bool resets = true;                         ///< warm-start reset before this input (ResetRule)
  bool lacks_neighbour = false;               ///< the forces of a neighbour are unknown and taken as zero
};

/// Determines the inputs at which an evaluator resets its warm start.
///
/// A result depends, within the tolerance, on the previous one, from which it is started. Live node and replay must
/// give identical results, wherever they begin and whatever the number of threads. Both therefore apply one rule, which
/// depends only on the stamps. The warm start is reset at every whole second, where a stamp decreases, and after
/// `slice_capacity` results. A repeated stamp causes no reset. The inputs between two resets are called a slice.
class ResetRule
{
 public:
  static constexpr int slice_capacity = 200;  ///< largest number of inputs in a slice

  /// True if these successive stamps cause a reset, whatever the number of inputs in the slice.
  static bool isBoundary(const ros::Time& before, const ros::Time& stamp)
  {
    return stamp.sec != before.sec || stamp < before;
  }

  /// Adds the stamp of the next input. @return true if the warm start is reset before this input.
  bool resets(const ros::Time& stamp)
  {
    const bool is_first = count_ == 0 || count_ == slice_capacity || isBoundary(last_, stamp);
    last_ = stamp;
    count_ = is_first ? 1 : count_ + 1;
    return is_first;
  }

 private:
  ros::Time last_;
  int count_ = 0;  ///< number of inputs in the slice
};

/// Prepares the inputs of one wheelset, in order, for evaluation: transform, checks and the forces of the neighbours.
class InputPreparation
{
 public:
  /// Longest time that an input waits for its transform, from its arrival [s].
  static constexpr double transform_timeout = 0.1;

  /// Keeps no reference to `config`.
  /// @param transforms,neighbours must outlive the preparation
  InputPreparation(const NodeConfig& config, const TransformStore& transforms, const NeighbourForces& neighbours)
      : track_frame_(config.track_frame),
        fixed_frame_(config.fixed_frame),
        path_(config.path),
        transforms_(transforms),
        neighbours_(neighbours)
  {
  }

  /// True if the input need not wait: its pose needs no transform, its frame_id is invalid, or tf has the transform.
  bool isReady(const ContactInput& input) const;
  /// Does not throw for an unusable input: see PreparedInput::status.
  PreparedInput prepare(const ContactInput& input);
  /// The next input is prepared as the first one.
  void restart() { reset_rule_ = ResetRule(); }

 private:
  /// Frame to which tf transforms the poses.
  const std::string& tfFrame() const { return path_ ? fixed_frame_ : track_frame_; }

  std::string track_frame_, fixed_frame_;
  std::shared_ptr<const core::TrackPath> path_;
  const TransformStore& transforms_;
  const NeighbourForces& neighbours_;
  ResetRule reset_rule_;
};
}  // namespace wheel_rail_contact
