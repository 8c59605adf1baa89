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

/// Copies the force, the axes and the radius of a patch of the core or of a message.
template <typename Patch>
void copySizes(const Patch& patch, ContactPoint& point)
{
  point.normal_force = patch.normal_force;
  point.semi_axis_along = patch.semi_axis_along;
  point.semi_axis_across = patch.semi_axis_across;
  point.rolling_radius = patch.rolling_radius;
}

/// What comes back.
struct ContactReply
{
  bool is_usable = false;            ///< whether z, roll and contacts are valid
  std::string status;                ///< name of the status, and its reason if there is one: "OFF_PROFILE: ..."
  double z = 0;                      ///< solved height of the axle centre, track frame [m]
  double roll = 0;                   ///< solved rotation about x, positive if the left wheel is raised [rad]
  std::vector<ContactPoint> points;  ///< left side first
};

/// Text of ContactReply::status.
inline std::string statusText(const std::string& name, const std::string& reason)
{
  return reason.empty() ? name : name + ": " + reason;
}

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

/// Contact of each step, or the last usable one while there is none: without forces the wheelset would fall and drift
/// as after a lift-off, and nothing would show it.
class HeldContact
{
 public:
  /// @param most largest number of successive steps with the last usable contact
  HeldContact(ContactSource& source, int most) : source_(source), most_(most) {}

  /// Contact for the request.
  /// @throw std::runtime_error if more than `most` successive states, or the first one, have no usable result.
  const ContactReply& evaluate(const ContactRequest& request);

  /// Number of steps with a held contact.
  int held() const { return held_; }
  /// Whether the last contact is held.
  bool isHeld() const { return in_a_row_ > 0; }

 private:
  ContactSource& source_;
  const int most_;
  ContactReply last_;
  int held_ = 0, in_a_row_ = 0;
};
}  // namespace simulate_wheelset
