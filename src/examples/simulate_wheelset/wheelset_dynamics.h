// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "examples/simulate_wheelset/contact_source.h"
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
};

/// Contact of each step, or the last usable one while there is none: without forces the wheelset would fall and drift
/// as after a lift-off, and nothing would show it.
class HeldContact
{
 public:
  /// @param most largest number of successive steps with the last usable contact
  HeldContact(ContactSource& source, int most) : source_(source), most_(most) {}

  /// Contact for the first request of a step.
  /// @throw std::runtime_error if more than `most` successive steps, or the first one, have no usable result.
  const ContactReply& evaluate(const ContactRequest& request);
  /// Contact for a further request of this step; the last usable one if it has none.
  const ContactReply& evaluateAgain(const ContactRequest& request);

  /// Number of steps with a held contact.
  int held() const { return held_; }
  /// Whether the last step has a held contact.
  bool isHeld() const { return in_a_row_ > 0; }

 private:
  ContactSource& source_;
  const int most_;
  ContactReply last_;
  int held_ = 0, in_a_row_ = 0;
};

/// Equations of motion of one wheelset on its primary suspension, running at a constant speed V.
///
/// Lateral displacement and yaw have inertia. Height, roll and the rotation W about the axle follow from the contact.
///
///   m y''     = Y - 2 k_y y - 2 c_y y'
///   I_z yaw'' = M_z - 2 b_s^2 (k_x yaw + c_x yaw') - I_y W roll'
///   force_z   = -axle_load - m z_line''
///   torque_x  = -2 k_z b_s^2 roll - I_x roll_line'' + I_y W yaw'
///
/// Y and M_z are whole forces of the rails: normal forces and friction. The last terms are gyroscopic moments and the
/// inertia on a line; z_line and roll_line are those of the rails by the line.
///
/// A step solves for the new velocities, with the contact at the old y and the new yaw: m (v_new - v_old) = step
/// F(v_new). Reason: the damping by friction grows as 1/V. At 2 m/s it is 10000 1/s for y' and yaw', which an explicit
/// step of 1 ms does not resolve. The step adds no damping to the kinematic oscillation or to that on the springs. The
/// iteration is Newton's with the derivatives of an earlier step while these suffice: one to three contacts per step.
class WheelsetDynamics
{
 public:
  explicit WheelsetDynamics(const Parameters& parameters);

  /// Motion at the start, or after the last step.
  const Motion& motion() const { return motion_; }
  /// State at the start of the next step, and its load.
  ContactRequest request() const;
  /// Advances the motion by one step. @return the contact in the step
  /// @throw std::runtime_error if the new velocities do not converge, or as HeldContact::evaluate().
  const ContactReply& advance(HeldContact& contact);

 private:
  ContactRequest requestAt(const Eigen::Vector2d& velocities) const;
  Eigen::Vector2d residual(const Eigen::Vector2d& velocities, const ContactReply& contact) const;
  void differentiate(const Eigen::Vector2d& velocities, const Eigen::Vector2d& value, HeldContact& contact);
  void addLine(const Eigen::Vector2d& height_and_roll);
  void finish(const Eigen::Vector2d& velocities, const ContactReply& contact);

  Parameters parameters_;
  const double step_;  ///< [s]
  std::int64_t steps_ = 0;
  Motion motion_;
  double roll_ = 0, roll_rate_ = 0, rotation_ = 0;             ///< of the last step [rad], [rad/s]
  std::array<Eigen::Vector2d, 3> line_;                        ///< height [m] and roll [rad] of the last steps
  Eigen::Vector2d change_ = Eigen::Vector2d::Zero();           ///< of the velocities in the last step
  Eigen::Matrix2d correction_ = -Eigen::Matrix2d::Identity();  ///< change of the velocities by a residual
};
}  // namespace simulate_wheelset
