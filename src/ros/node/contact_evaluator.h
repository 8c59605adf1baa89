// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>

#include <cstdint>
#include <string>

#include <wheel_rail_contact/WheelsetContact.h>
#include "core/track/placement.h"
#include "ros/node/contact_input.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// Output for one input, before it becomes messages and markers.
struct ContactOutput
{
  std_msgs::Header header;                               ///< stamp of the pose; frame_id is the track frame
  std::uint8_t status = WheelsetContact::INVALID_INPUT;  ///< constant of the message WheelsetContact
  std::string reason;                            ///< text; empty if OK, within the tolerance and the linear range
  core::WheelsetState state;                     ///< as given; zero if the input was unusable
  const core::WheelsetResult* result = nullptr;  ///< null unless usable; valid until the next evaluation
  std::string beyond_linear_range;  ///< text on each rail whose |Y|/Q exceeds the range of its table; else empty
  bool lacks_neighbour = false;     ///< evaluated without the forces of a neighbour (NeighbourForces)

  /// Axle centre along the track [m].
  double x() const { return state.x; }
  /// Solved if usable, otherwise as given.
  core::WheelsetPose pose() const;
};

/// Evaluates inputs: the part that live node and replay share. Not thread-safe.
class ContactEvaluator
{
 public:
  /// @throw std::invalid_argument for a configuration that the core rejects.
  explicit ContactEvaluator(const NodeConfig& config);

  /// Returns one output for each input. Never throws for an unusable input: see ContactOutput::status.
  ContactOutput evaluate(const PreparedInput& input);

 private:
  std::string track_frame_;
  double linear_range_;
  core::WheelsetContact contact_;
};

/// Text with side, forces and ratio of each rail whose |Y|/Q exceeds the range of its compliance table; empty if none
/// does.
std::string linearRangeWarning(const core::WheelsetResult& result, double linear_range);

/// @param with_grids false leaves the pressure grids empty
/// @param solve_time wall time of the evaluation [s]
WheelsetContact toMessage(const ContactOutput& output, bool with_grids, double solve_time);

/// The output that a message was made from. Fills `result`; a usable output refers to it.
/// @throw std::invalid_argument as fromMessage() does for the result.
ContactOutput outputFromMessage(const WheelsetContact& message, core::WheelsetResult& result);
}  // namespace wheel_rail_contact
