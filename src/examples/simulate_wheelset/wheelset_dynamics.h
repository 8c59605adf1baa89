// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "examples/simulate_wheelset/contact_source.h"
#include "examples/simulate_wheelset/creep_force.h"
#include "examples/simulate_wheelset/parameters.h"

namespace simulate_wheelset
{
/// Motion of the wheelset besides its steady running, in the track frame.
struct Motion
{
  double y = 0;         ///< lateral displacement of the axle centre, to the left positive [m]
  double yaw = 0;       ///< to the left positive [rad]
  double y_rate = 0;    ///< [m/s]
  double yaw_rate = 0;  ///< [rad/s]
  double spin = 0;      ///< angular velocity about the axle, positive for forward rolling [rad/s]
};

/// Force and moment of the rails on the wheelset, track axes; moments about the axle centre.
struct RailForces
{
  Eigen::Vector3d normal_force = Eigen::Vector3d::Zero();   ///< of the normal forces [N]
  Eigen::Vector3d normal_moment = Eigen::Vector3d::Zero();  ///< [N m]
  Eigen::Vector3d creep_force = Eigen::Vector3d::Zero();    ///< of the creep forces [N]
  Eigen::Vector3d creep_moment = Eigen::Vector3d::Zero();   ///< [N m]
  double spin_moment = 0;         ///< of the creep forces about the axle; accelerates forward rolling if positive [N m]
  std::vector<CreepForce> creep;  ///< of each contact
  double friction_power = 0;      ///< that the creep forces turn into heat [W]

  /// Whole force [N].
  Eigen::Vector3d force() const { return normal_force + creep_force; }
  /// Whole moment [N m].
  Eigen::Vector3d moment() const { return normal_moment + creep_moment; }
};

/// Rates that follow from the motion, because both wheels stay on their rails.
struct FollowingRates
{
  double z = 0;     ///< of the height of the axle centre [m/s]
  double roll = 0;  ///< [rad/s]
};

/// Rates of height and roll for which the main contact of each wheel has no velocity along its normal. Differences of
/// successive results would be ill-conditioned at low speed. The motion of the rails below the wheel (irregularities)
/// is neglected: its slope is small compared with that of the contact.
FollowingRates followingRates(const ContactReply& contact, const Motion& motion);

/// Creepage at a contact: velocity of the wheel there, without the motion along the normal, over the running speed.
/// The rotation of the wheel about its axle moves no point of a contact along the normal.
/// @param roll  rotation of the axle about x [rad]
/// @param speed running speed V [m/s], > 0
Creepage creepageAt(const ContactPoint& point, const Motion& motion, const FollowingRates& rates, double roll,
                    double speed);

/// Forces of the rails in one state of motion.
RailForces railForces(const ContactReply& contact, const Motion& motion, double speed, const CreepLaw& law);

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
