// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace simulate_wheelset
{
/// What the dynamics send: pose, velocities and load of the wheelset at one instant, in the track frame (x forward, y
/// left, z up).
struct ContactRequest
{
  std::int64_t time = 0;  ///< since the start [ns]
  double distance = 0;    ///< place along the track [m]
  double y = 0;           ///< lateral displacement of the axle centre, to the left positive [m]
  double yaw = 0;         ///< rotation about z, to the left positive [rad]
  double speed = 0;       ///< velocity along the track [m/s]
  double y_rate = 0;      ///< lateral velocity, to the left positive [m/s]
  double yaw_rate = 0;    ///< angular velocity about z [rad/s]
  double force_z = 0;     ///< vertical force on the axle centre, of all but the rails, up positive [N]
  double torque_x = 0;    ///< moment about x on the axle centre, of all but the rails [N m]
};

/// One contact between a wheel and its rail.
struct ContactPoint
{
  bool is_left = true;        ///< side of the wheel
  double angle = 0;           ///< rotation of the patch frame about x, right-handed [rad]
  double normal_force = 0;    ///< along z of the patch frame, on the wheel [N]
  double rolling_radius = 0;  ///< [m]
  double creep_x = 0;         ///< friction on the wheel along x [N]
  double creep_y = 0;         ///< friction on the wheel along y of the patch frame [N]
  double adhesion_share = 0;  ///< friction over the friction limit [-]
  double power = 0;           ///< that friction turns into heat [W]
};

/// What comes back.
struct ContactReply
{
  bool is_usable = false;  ///< whether the rest is valid
  std::string status;      ///< name of the status, and its reason if there is one: "OFF_PROFILE: ..."
  double z = 0;            ///< solved height of the axle centre, track frame [m]
  double roll = 0;         ///< solved rotation about x, positive if the left wheel is raised [rad]
  double rotation = 0;     ///< about the axle, free of moments about it [rad/s]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< of the rails on the wheelset, with friction, track axes [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< the same about the axle centre [N m]
  double line_left = 0, line_right = 0;              ///< height of each rail by the line, up positive [m]
  std::vector<ContactPoint> points;                  ///< left side first
};

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
