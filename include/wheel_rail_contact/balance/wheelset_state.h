// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "wheel_rail_contact/rail/compliance.h"

namespace wheel_rail_contact
{
/// What is known of a wheelset at one instant; track frame (x forward, y left, z up).
struct WheelsetState
{
  double y = 0;                                ///< axle centre, to the left [m]
  double z = 0;                                ///< axle centre, up [m]; used only if height and roll are given
  double yaw = 0;                              ///< about z [rad]
  double roll = 0;                             ///< about x [rad]; used only if height and roll are given
  double force_z = 0;                          ///< vehicle's force on the axle centre, up [N]; negative presses down
  double torque_x = 0;                         ///< vehicle's moment on the axle centre about x [N m]
  std::array<double, 2> rail_lateral_force{};  ///< outward force on the rail by Side [N], for LateralForce::topic
  /// Deflection of each rail by Side that other wheelsets' forces cause here, for model compliance.
  std::array<RailDeflection, 2> rail_offset{};
};

/// Whether an answer may be used, and if not, why.
enum class ContactStatus
{
  ok,             ///< every loaded wheel in contact, usable
  lift_off,       ///< at least one wheel carries nothing, the rest is solved; usable
  off_profile,    ///< contact would lie beyond the end of a profile
  not_converged,  ///< normal solution, balance or coupling did not converge
  invalid_input   ///< NaN or infinite input, or angles out of range
};

/// What a rail does under its forces, axes of its side.
struct RailResult
{
  RailDeflection deflection;  ///< of the head
  double lateral_force = 0;   ///< that bends the rail, outward [N]
  double vertical_force = 0;  ///< down [N]
  double moment = 0;          ///< of both about the head's reference point, outward roll positive [N m]
  /// True if the contact was solved on the rail as these forces bend it. False where nothing bends it, or too little to
  /// change the contact by a good part of the tolerance: then the deflection is reported, and counts in the axle's
  /// height, but the gap is that of the rail without it.
  bool coupled = false;
};

/// True if the answer's pressures may be used.
inline bool isUsable(ContactStatus status)
{
  return status == ContactStatus::ok || status == ContactStatus::lift_off;
}
}  // namespace wheel_rail_contact
