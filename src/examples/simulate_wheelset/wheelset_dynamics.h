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
/// inertia. Gyroscopic moments are neglected: at 40 m/s they are about 1 % of those of the creep forces.
///
///   m y''          = Y - 2 k_y y - 2 c_y y'
///   I_z yaw''      = M_z - 2 b_s^2 (k_x yaw + c_x yaw')
///   I_y spin'      = M of the creep forces about the axle
///
/// One step evaluates the contact once, at the old position. Position-dependent forces are those of the old position,
/// and the creepages those of the new velocities and the new yaw. The equation for the new velocities is solved by
/// Newton's method. Reason: the damping of the creep forces grows as 1/V, to 10000 1/s at 2 m/s, which an explicit step
/// of 1 ms does not resolve. The step adds no damping to the kinematic oscillation or to that on the springs.
class WheelsetDynamics
{
 public:
  explicit WheelsetDynamics(const Parameters& parameters);

  /// Motion at the start, with the spin of free rolling.
  const Motion& motion() const { return motion_; }
  /// Forces of the rails in the last step.
  const RailForces& forces() const { return forces_; }

  /// Load for the next contact. It has to hold the forces that the contact calculation does not know: the vertical part
  /// of the creep forces, and the moment of all lateral forces of the rails, which act r0 below the axle centre.
  /// `torque_x` is therefore the moment that the vertical forces of the wheels must carry (wheelset/balance:
  /// wheel_loads). The lateral forces are those of the last step.
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
  CreepLaw law_;
  Motion motion_;
  RailForces forces_;
};
}  // namespace simulate_wheelset
