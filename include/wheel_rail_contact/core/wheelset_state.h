// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "wheel_rail_contact/core/rail_compliance.h"

namespace wheel_rail_contact::core
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
  double x = 0;  ///< axle centre, along the track [m]; copied to the result
};
}  // namespace wheel_rail_contact::core
