// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "wheel_rail_contact/core/wheelset_result.h"

namespace simulate_wheelset
{
/// What the dynamics send: time, and pose, velocities and load of the wheelset. Height, roll and rotation are results.
struct ContactRequest
{
  std::int64_t time = 0;                          ///< since the start [ns]
  wheel_rail_contact::core::WheelsetState state;  ///< track frame; `distance` is the place along the track
};

/// What comes back. Over a node, of `rail` only the given height, and of a patch only side, angle, force, rolling
/// radius and friction.
using ContactReply = wheel_rail_contact::core::WheelsetResult;

/// A way to the contact calculation: all that the dynamics use of it.
class ContactSource
{
 public:
  virtual ~ContactSource() = default;
  ContactSource() = default;
  ContactSource(const ContactSource&) = delete;
  ContactSource& operator=(const ContactSource&) = delete;

  /// Contact in one state. States of one step have one time.
  /// @throw std::runtime_error if the calculation cannot be reached. A state without a usable result does not throw.
  virtual ContactReply evaluate(const ContactRequest& request) = 0;
};
}  // namespace simulate_wheelset
