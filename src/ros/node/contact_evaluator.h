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
/// Answer to one input, before it becomes messages and markers.
struct ContactAnswer
{
  std_msgs::Header header;                               ///< the pose's stamp, the track frame
  std::uint8_t status = WheelsetContact::INVALID_INPUT;  ///< constant of the message WheelsetContact
  std::string reason;       ///< in words, empty when OK and within tolerance and linear range
  double x = 0;             ///< axle centre along the track [m]
  core::WheelsetPose pose;  ///< solved if usable, otherwise as given; zero if the input was unusable
  const core::WheelsetResult* result = nullptr;  ///< null unless usable; valid until the next evaluation
  std::string beyond_linear_range;  ///< figures of a rail whose |Y|/Q is beyond its table's range, else empty
  bool above_tolerance = false;     ///< a patch's error estimate is above contact/tolerance
  bool lacks_neighbour = false;     ///< evaluated without the forces of a neighbour (NeighbourForces)
};

/// One answer for each input: what the live node and the replay have in common. Not thread-safe.
class ContactEvaluator
{
 public:
  /// @throw std::invalid_argument as the core does for a configuration it cannot use.
  explicit ContactEvaluator(const NodeConfig& config);

  /// Never throws for an unusable input: the answer's status tells.
  ContactAnswer answer(const PreparedInput& input);

 private:
  std::string track_frame_;
  double linear_range_;
  core::WheelsetContact contact_;
};

/// Says side, forces and ratio of each rail whose |Y|/Q is greater than its compliance table allows; empty if none is.
std::string linearRangeWarning(const core::WheelsetResult& result, double linear_range);

/// @param with_grids false leaves the pressure grids empty
/// @param solve_time wall time of the evaluation [s]
WheelsetContact toMessage(const ContactAnswer& answer, bool with_grids, double solve_time);

/// The answer in a message. `result` is filled, and referred to by the answer if that is usable.
/// @throw std::invalid_argument as fromMessage() does for the result.
ContactAnswer answerFromMessage(const WheelsetContact& message, core::WheelsetResult& result);
}  // namespace wheel_rail_contact
