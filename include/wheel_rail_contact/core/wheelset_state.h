// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "wheel_rail_contact/core/rail_compliance.h"

namespace wheel_rail_contact::core
{
/// Pose and load of a wheelset at one instant: the input of WheelsetContact::evaluate().
///
/// Track frame: x forward, y left, z up; z = 0 is the plane on the tops of both undeflected rails. The axle is rolled
/// first, then yawed (fixed axes). A value that is not finite or beyond its limit below gives a result with the status
/// ContactStatus::invalid_input.
struct WheelsetState
{
  double y = 0;  ///< lateral displacement of the axle centre, to the left positive [m]; at most 0.1 m from the
                 ///< middle of both displaced rails
  /// Height of the axle centre [m]; |z| <= 1. Used only if WheelsetConfig::solve_height_and_roll is false.
  double z = 0;
  double yaw = 0;  ///< rotation of the axle about z, positive to the left [rad]; |yaw| <= 0.2
  /// Rotation of the axle about x, positive if the left wheel is raised [rad]; |roll| <= 0.2. Used only if
  /// WheelsetConfig::solve_height_and_roll is false.
  double roll = 0;
  /// Vertical force on the axle centre, up positive [N], of everything but the normal pressure of the rails: of the
  /// vehicle, the weight of the wheelset itself (negative), inertia, and friction. |force_z| <= 1e8. Not required if
  /// height and roll are given.
  double force_z = 0;
  /// Moment on the axle centre about x [N m]: a positive moment unloads the left wheel. |torque_x| <= 1e8. Not required
  /// if height and roll are given. With Balance::wheel_loads, it is the moment that the vertical forces of the rails
  /// balance alone, at the running circles: it also contains the moment of all lateral forces on the wheels. With
  /// Balance::moments, it is the moment of all forces except those of the normal pressure: of the vehicle, and of
  /// friction.
  double torque_x = 0;
  /// Lateral force on the rail of each Side, outward positive [N]; at most 1e8. Used only with
  /// RailBendingConfig::LateralForce::topic.
  std::array<double, 2> rail_lateral_force{};
  /// Displacement of the rail of each Side at this wheelset, besides its deflection under this wheel: by a track model
  /// of the caller, or by the forces of other wheelsets. At most 0.1 m and 0.2 rad. Added to RailBendingConfig.
  std::array<RailDeflection, 2> rail_displacement{};
  double x = 0;         ///< position of the axle centre along the track [m]; not checked, only copied to the result
  double distance = 0;  ///< place of the wheelset on TrackConfig::line and on rails with sections [m]
};
}  // namespace wheel_rail_contact::core
