// SPDX-License-Identifier: BSD-3-Clause
#include "core/friction/moved_friction.h"

#include <cmath>

#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr int vertical_velocity = 2, roll_rate = 3;
constexpr double small_creepage = 1e-9;  ///< a free rotation leaves little of the change by the speed

/// Step of a velocity for differences [m/s], [rad/s].
double stepOf(std::size_t velocity, const WheelsetMotion& motion, double radius)
{
  return small_creepage * std::abs(motion.speed) / (velocity < 3 ? 1 : radius);
}
}  // namespace

/// Friction of a contact at a motion.
MovedFriction::Values MovedFriction::solved(RollingContact& contact, const WheelsetMotion& motion) const
{
  const bool own_force = config_.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact;
  Values values = Values::Constant(NAN);
  if (isUsable(contact.solve(motion, false)))
  {
    const Wrench wrench = contact.onWheelset();
    values << wrench.force, wrench.moment, contact.onRail(own_force);
  }
  return values;
}

/// Motion of an axle after a movement of a wheel: its yaw and roll are those of the axle.
WheelsetMotion MovedFriction::turned(WheelsetMotion motion, Side side, int movement, double step)
{
  constexpr int roll = 2, yaw = 3;
  motion.roll += movement == roll ? sideSign(side) * step : 0;
  motion.yaw += movement == yaw ? sideSign(side) * step : 0;
  return motion;
}

void MovedFriction::addMotions(RollingContact& contact, const WheelsetMotion& motion, Friction& friction) const
{
  friction.values = solved(contact, motion);
  for (std::size_t i = 0; i < velocities_of_motion.size(); ++i)
  {
    WheelsetMotion ahead = motion;
    const double step = stepOf(i, motion, config_.wheelset.meanRadius());
    ahead.*velocities_of_motion[i] += step;
    friction.by_motion.col(static_cast<Eigen::Index>(i)) = (solved(contact, ahead) - friction.values) / step;
  }
}

void MovedFriction::addMovements(RollingContact& contact, MovedContact& wheel, const WheelsetMotion& motion,
                                 Friction& friction) const
{
  for (int m = 0; m < MovedContact::movements; ++m)
  {
    const double step = MovedContact::stepOf(m);
    std::array<Values, 2> values;
    for (const int direction : {-1, 1})
    {
      const std::size_t place = direction > 0 ? 1 : 0;
      contact.placeMoved(wheel.pressed(m, direction, contact.grid()));
      friction.centres[static_cast<std::size_t>(m)][place] = contact.centre();
      values[place] = solved(contact, turned(motion, contact.side(), m, direction * step));
    }
    friction.by_movement.col(m) = (values[1] - values[0]) / (2 * step);
  }
}

/// Vertical velocity and roll rate with which a contact follows its rail at a motion, after a movement of a wheel.
Eigen::Vector2d MovedFriction::following(const RollingWheelset& rolling, std::size_t contact, WheelsetMotion motion,
                                         Side side, int movement, int direction) const
{
  const auto centre = [&](std::size_t k) -> const ContactPlace&
  {
    return movement >= 0 && contacts_[k].side == side
               ? contacts_[k].centres[static_cast<std::size_t>(movement)][direction > 0 ? 1 : 0]
               : contacts_[k].centre;
  };
  if (movement >= 0 && contacts_[contact].side == side)
  {
    motion = turned(motion, side, movement, direction * MovedContact::stepOf(movement));
  }
  const std::size_t left = rolling.strongest(Side::left), right = rolling.strongest(Side::right);
  followRails(centre(std::min(left, right)), centre(right < rolling.count() ? right : left), motion);
  const ContactPlace& place = centre(contact);
  return {motion.vertical_velocity - normalVelocity(motion, place) / patchAxes(place)(2, 2), motion.roll_rate};
}

void MovedFriction::follow(const RollingWheelset& rolling, std::size_t contact)
{
  Eigen::Matrix<double, 2, inputs>& follow = contacts_[contact].follow;
  follow.setZero();
  const WheelsetMotion& motion = rolling.motion();
  for (const Side side : sides)
  {
    for (int m = 0; m < MovedContact::movements && rolling.strongest(side) < rolling.count(); ++m)
    {
      follow.col(MovedContact::movements * static_cast<int>(side) + m) =
          (following(rolling, contact, motion, side, m, 1) - following(rolling, contact, motion, side, m, -1)) /
          (2 * MovedContact::stepOf(m));
    }
  }
  for (std::size_t i = 0; i < velocities_of_motion.size(); ++i)
  {
    WheelsetMotion ahead = motion;
    const double step = stepOf(i, motion, config_.wheelset.meanRadius());
    ahead.*velocities_of_motion[i] += step;
    follow.col(first_motion + static_cast<Eigen::Index>(i)) =
        (following(rolling, contact, ahead) - following(rolling, contact, motion)) / step;
  }
}

void MovedFriction::find(RollingWheelset& rolling, Sides<MovedContact>& wheels)
{
  contacts_.resize(rolling.count());
  for (std::size_t k = 0; k < contacts_.size(); ++k)
  {
    RollingContact& contact = rolling.contact(k);
    contacts_[k].side = contact.side();
    contacts_[k].centre = contact.centre();
    const WheelsetMotion motion = contact.motion();
    addMotions(contact, motion, contacts_[k]);
    addMovements(contact, wheels[contact.side()], motion, contacts_[k]);
  }
  for (std::size_t k = 0; k < contacts_.size() && config_.wheelset.solve_height_and_roll; ++k)
  {
    follow(rolling, k);
  }
}

MovedFriction::Values MovedFriction::values(Side side) const
{
  Values sum = Values::Zero();
  for (const Friction& contact : contacts_)
  {
    sum += (contact.side == side ? 1 : 0) * contact.values;
  }
  return sum;
}

MovedFriction::Changes MovedFriction::changes(Side side, bool follows) const
{
  Changes sum = Changes::Zero();
  for (const Friction& contact : contacts_)
  {
    if (contact.side == side)
    {
      sum.middleCols<MovedContact::movements>(MovedContact::movements * static_cast<int>(side)) += contact.by_movement;
      sum.rightCols<6>() += contact.by_motion;
      if (follows)
      {
        sum.middleCols<2>(first_motion + vertical_velocity) -= contact.by_motion.middleCols<2>(vertical_velocity);
        sum += contact.by_motion.middleCols<2>(vertical_velocity) * contact.follow;
      }
    }
  }
  return sum;
}
}  // namespace wheel_rail_contact::core
