// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "examples/simulate_wheelset/contact_source.h"
#include "examples/simulate_wheelset/creep_force.h"

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
}  // namespace simulate_wheelset
