// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace simulate_wheelset
{
/// What the dynamics send: pose and load of the wheelset at one instant, in the track frame (x forward, y left, z up).
struct ContactRequest
{
  std::int64_t time = 0;  ///< since the start [ns]
  double distance = 0;    ///< place along the track [m]
  double y = 0;           ///< lateral displacement of the axle centre, to the left positive [m]
  double yaw = 0;         ///< rotation about z, to the left positive [rad]
  double force_z = 0;     ///< vertical force on the axle centre, up positive: the weight of the wheelset included [N]
  double torque_x = 0;    ///< moment about x on the axle centre [N m]
};

/// One contact between a wheel and its rail.
struct ContactPoint
{
  bool is_left = true;                                 ///< side of the wheel
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centre of pressure from the axle centre, track axes [m]
  double angle = 0;                                    ///< rotation of the patch frame about x, right-handed [rad]
  double normal_force = 0;                             ///< along z of the patch frame, on the wheel [N]
  double semi_axis_along = 0;                          ///< [m]
  double semi_axis_across = 0;                         ///< [m]
  double rolling_radius = 0;                           ///< [m]
};

/// What comes back.
struct ContactReply
{
  bool is_usable = false;            ///< whether z, roll and contacts are valid
  std::string status;                ///< name of the status, and its reason if there is one: "OFF_PROFILE: ..."
  double z = 0;                      ///< solved height of the axle centre, track frame [m]
  double roll = 0;                   ///< solved rotation about x, positive if the left wheel is raised [rad]
  std::vector<ContactPoint> points;  ///< left side first
};

/// A way to the contact calculation: all that the dynamics use of it.
class ContactSource
{
 public:
  virtual ~ContactSource() = default;
  ContactSource() = default;
  ContactSource(const ContactSource&) = delete;
  ContactSource& operator=(const ContactSource&) = delete;

  /// Nominal rolling radius of the contact calculation, the mean of both wheels [m], > 0.
  virtual double rollingRadius() const = 0;

  /// Contact in one state.
  /// @throw std::runtime_error if the calculation cannot be reached. A state without a usable result does not throw.
  virtual ContactReply evaluate(const ContactRequest& request) = 0;
};
}  // namespace simulate_wheelset
