// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>

#include <cstdint>
#include <memory>
#include <string>

#include <wheel_rail_contact/WheelsetContact.h>
#include "core/track/placement.h"
#include "ros/evaluation/contact_input.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// Result for one input, from which messages and markers are made.
struct ContactOutput
{
  std_msgs::Header header;                               ///< stamp of the pose; frame_id is the track frame
  std::uint8_t status = WheelsetContact::INVALID_INPUT;  ///< constant of the message WheelsetContact
  std::string reason;                                    ///< status_text; empty if OK and without a warning
  bool rejected = false;                                 ///< the input was rejected before the evaluation
  core::WheelsetState state;                             ///< input of the evaluation; zero if it was rejected
  std::shared_ptr<const core::WheelsetResult> result;    ///< null unless usable or held
  std::string beyond_linear_range;  ///< linearRangeWarning(); empty if both rails are within the linear range
  bool held = false;                ///< not usable; `result` is the last usable one (HoldLast)
  bool lacks_neighbour = false;     ///< evaluated without the forces of a neighbour (NeighbourForces)
  double solve_time = 0;            ///< wall time of the evaluation [s]; 0 in a replay

  /// Position of the axle centre along the track [m].
  double x() const { return state.x; }
  /// Wheelset pose, track frame: that of the result, otherwise as in the input.
  core::WheelsetPose pose() const;
  /// Discards the result, of which only the pose remains.
  void release();
};

/// False for an output without a pose of the wheelset: an input that was rejected before the evaluation, or without a
/// height (the height z is exactly 0).
bool hasPose(const ContactOutput& output);

/// Evaluates inputs, for the live node and for the replay. Not thread-safe.
class ContactEvaluator
{
 public:
  /// @throw std::invalid_argument if the core rejects the configuration.
  explicit ContactEvaluator(const NodeConfig& config);

  /// Returns one output for each input. Does not throw for an unusable input: see ContactOutput::status.
  ContactOutput evaluate(const PreparedInput& input);

 private:
  std::string track_frame_;
  core::Sides<double> linear_range_;
  std::string warnings_;  ///< of the parameters; in the status text of each result after a reset
  core::WheelsetContact contact_;
};

/// Message of an output.
/// @param with_grids false: the pressure grids are left empty
WheelsetContact toMessage(const ContactOutput& output, bool with_grids);

/// Output from which a message was made.
/// @throw std::invalid_argument for an unknown constant or method, or a grid of the wrong size (fromMessage()).
ContactOutput outputFromMessage(const WheelsetContact& message);
}  // namespace wheel_rail_contact
