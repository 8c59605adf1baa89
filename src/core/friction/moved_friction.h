// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/balance/moved_contact.h"
#include "core/friction/rolling_wheelset.h"

namespace wheel_rail_contact::core
{
/// Velocities of a motion in the order of ContactDerivatives.
constexpr std::array<double WheelsetMotion::*, 6> velocities_of_motion{
    &WheelsetMotion::speed,     &WheelsetMotion::lateral_velocity, &WheelsetMotion::vertical_velocity,
    &WheelsetMotion::roll_rate, &WheelsetMotion::yaw_rate,         &WheelsetMotion::rotation};

/// Change of the friction of a wheelset by movements of the wheels on their rails and by its motion: differences of the
/// solution of each contact, on the pressure of MovedContact.
class MovedFriction
{
 public:
  /// Movements of the left wheel as in MovedContact, of the right one, and the motion over ground.
  static constexpr int first_motion = 2 * MovedContact::movements, inputs = first_motion + 6;
  using Values = MovedContact::Outputs;
  using Changes = Eigen::Matrix<double, MovedContact::outputs, inputs>;

  /// Keeps a reference to `config`, which must outlive this.
  explicit MovedFriction(const ContactModelConfig& config) : config_(config) {}

  /// Finds the changes of a solution. Its contacts are then those of the last movement.
  void find(RollingWheelset& rolling, Sides<MovedContact>& wheels);

  /// Of the wheel of a side.
  Values values(Side side) const;
  /// @param follows  vertical velocity and roll rate follow from the other inputs: no contact opens or closes
  Changes changes(Side side, bool follows) const;

 private:
  /// A contact.
  struct Friction
  {
    Side side = Side::left;
    Values values;
    MovedContact::Changes by_movement;  ///< of its own wheel
    Eigen::Matrix<double, MovedContact::outputs, 6> by_motion;
    Eigen::Matrix<double, 2, inputs> follow;  ///< vertical velocity and roll rate
    ContactPlace centre;
    std::array<std::array<ContactPlace, 2>, MovedContact::movements> centres;  ///< moved back and forward
  };

  Values solved(RollingContact& contact, const WheelsetMotion& motion) const;
  static WheelsetMotion turned(WheelsetMotion motion, Side side, int movement, double step);
  void addMotions(RollingContact& contact, const WheelsetMotion& motion, Friction& friction) const;
  void addMovements(RollingContact& contact, MovedContact& wheel, const WheelsetMotion& motion,
                    Friction& friction) const;
  Eigen::Vector2d following(const RollingWheelset& rolling, std::size_t contact, WheelsetMotion motion,
                            Side side = Side::left, int movement = -1, int direction = 0) const;
  void follow(const RollingWheelset& rolling, std::size_t contact);

  const ContactModelConfig& config_;
  std::vector<Friction> contacts_;
};
}  // namespace wheel_rail_contact::core
