// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "examples/simulate_wheelset/contact_source.h"
#include "examples/simulate_wheelset/parameters.h"
#include "examples/simulate_wheelset/wheelset_forces.h"

namespace simulate_wheelset
{
/// Equations of motion of one wheelset on its primary suspension, running at a constant speed.
///
/// Lateral displacement, yaw and rotation about the axle have inertia; height and roll follow from the load without
/// inertia. Gyroscopic moments are neglected. In the limit cycle at 40 m/s, they are up to 0.4 kN m about z, 2 % of
/// that of the creep forces, and 3 kN m about x, which would move 2 kN from one wheel to the other.
///
///   m y''          = Y - 2 k_y y - 2 c_y y'
///   I_z yaw''      = M_z - 2 b_s^2 (k_x yaw + c_x yaw')
///   I_y spin'      = M of the creep forces about the axle
///
/// One step evaluates the contact once, at the old position. Position-dependent forces are those of the old position,
/// and the creepages those of the new velocities and the new yaw. The equation for the new velocities is solved by
/// Newton's method. Reason: the damping of the creep forces grows as 1/V. At 2 m/s it is 10000 1/s for y' and yaw', and
/// 33000 1/s for spin', which an explicit step of 1 ms does not resolve. The step adds no damping to the kinematic
/// oscillation or to that on the springs.
class WheelsetDynamics
{
 public:
  /// @param rolling_radius nominal radius r0 of the wheels [m], > 0
  WheelsetDynamics(const Parameters& parameters, double rolling_radius);

  /// Motion at the start, with the spin of free rolling.
  const Motion& motion() const { return motion_; }
  /// Forces of the rails in the last step.
  const RailForces& forces() const { return forces_; }

  /// Load for the next contact (wheelset/balance: wheel_loads), with the forces F of the rails in the last step.
  ///
  ///   force_z  = -axle_load + F_z of the creep forces
  ///   torque_x = -2 k_z b_s^2 roll + r0 F_y of the normal forces + M_x of the creep forces about the axle centre
  ///
  /// `torque_x` is the moment that the vertical normal forces must carry. The contact calculation places these at the
  /// running circles. It has no creep forces, and leaves out the lateral normal forces, r0 below the axle
  /// centre. M_x of the creep forces is that of their lateral and of their vertical parts.
  /// @param time  since the start [ns]
  /// @param roll  of the last contact [rad]
  ContactRequest request(std::int64_t time, double roll) const;

  /// Advances the motion by one step in this contact.
  /// @throw std::runtime_error if the new velocities do not converge.
  void advance(const ContactReply& contact);

 private:
  Eigen::Vector3d accelerations(const ContactReply& contact, const Motion& trial, RailForces& forces) const;
  Motion trialAt(const Eigen::Vector3d& velocities) const;

  Parameters parameters_;
  const double rolling_radius_, step_;  ///< [m], [s]
  CreepLaw law_;
  Motion motion_;
  RailForces forces_;
};
}  // namespace simulate_wheelset
