// SPDX-License-Identifier: BSD-3-Clause
#include "core/state_check.h"

#include <cmath>

#include "core/text/formatted.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double angle_limit = 0.2;         ///< largest accepted yaw and roll [rad]
constexpr double least_load = 1e3;          ///< smallest plausible mean wheel load at the default rolling radius [N]
constexpr double height_limit = 1.0;        ///< largest accepted axle height, if given [m]
constexpr double force_limit = 1e8;         ///< largest accepted load [N], [N m]
constexpr double displacement_limit = 0.1;  ///< largest accepted displacement of a rail [m]
constexpr double speed_limit = 1e3;         ///< largest accepted velocity of the axle centre [m/s]
constexpr double rate_limit = 1e4;          ///< largest accepted rotation of the axle [rad/s]

bool within(double value, double limit)
{
  return std::abs(value) <= limit;
}

bool within(const WheelsetMotion& motion)
{
  return within(motion.speed, speed_limit) && within(motion.lateral_velocity, speed_limit) &&
         within(motion.yaw_rate, rate_limit) && within(motion.roll_rate, rate_limit) &&
         within(motion.rotation, rate_limit) && within(motion.vertical_velocity, speed_limit);
}

bool within(const RailDeflection& displacement)
{
  return within(displacement.lateral, displacement_limit) && within(displacement.vertical, displacement_limit) &&
         within(displacement.roll, angle_limit);
}

bool within(const RailRates& velocity)
{
  return within(velocity.lateral, speed_limit) && within(velocity.vertical, speed_limit) &&
         within(velocity.roll, rate_limit);
}
}  // namespace

std::string_view faultOf(const WheelsetState& state, bool height_and_roll_given)
{
  if (!std::isfinite(state.y))
  {
    return "lateral position is not a number";
  }
  if (std::abs(state.roll) > angle_limit || (height_and_roll_given && std::isnan(state.roll)))
  {
    return "roll is not a number or beyond 0.2 rad";
  }
  if (!within(state.yaw, angle_limit))
  {
    return "yaw is not a number or beyond 0.2 rad";
  }
  if (!within(state.force_z, force_limit) || !within(state.torque_x, force_limit))
  {
    return "load is not a number or beyond 1e8 N";
  }
  if (!within(state.rail_lateral_force.left, force_limit) || !within(state.rail_lateral_force.right, force_limit))
  {
    return "lateral rail force is not a number or beyond 1e8 N";
  }
  if (!within(state.rail_displacement.left) || !within(state.rail_displacement.right))
  {
    return "displacement of a rail is not a number or beyond 0.1 m or 0.2 rad";
  }
  if (!within(state.rail_velocity.left) || !within(state.rail_velocity.right))
  {
    return "velocity of a rail is not a number or beyond 1000 m/s or 10000 rad/s";
  }
  if (!within(state.motion))
  {
    return "a velocity of the axle is not a number or beyond 1000 m/s or 10000 rad/s";
  }
  if (height_and_roll_given && !within(state.z, height_limit))
  {
    return "height is not a number or beyond 1 m";
  }
  return {};
}

std::string loadDoubt(double mean, const WheelsetConfig& wheelset)
{
  const double scale = wheelset.meanRadius() / WheelsetConfig().meanRadius();
  return mean <= -least_load * scale * scale ? formatted(
                                                   "the mean wheel load is %.4g kN, upward: force.z and loads as "
                                                   "reactions have the other sign",
                                                   1e-3 * mean)
         : mean < least_load * scale * scale
             ? formatted("the mean wheel load is %.4g N: loads must be in N, not in kN or t", mean + 0.0)  // no -0
             : "";
}

void LoadTally::add(const WheelsetState& state, bool lifts)
{
  ++count_;
  lifting_ += lifts ? 1U : 0U;
  sum_ += state.force_z;
}

std::string LoadTally::doubt(const WheelsetConfig& wheelset) const
{
  constexpr std::uint64_t fewest = 10;
  if (count_ < fewest || !wheelset.solve_height_and_roll)
  {
    return "";
  }
  const std::string text = loadDoubt(-0.5 * sum_ / static_cast<double>(count_), wheelset);
  return !text.empty() || lifting_ < count_ ? text : "a wheel lifts in all results: unit or sign of torque.x?";
}

std::string tooDeep(double height, double depth)
{
  return formatted(
      "the given height z = %.4f m is %.1f mm below first touch: it was never set, or is not that of the axle "
      "centre",
      height, 1e3 * depth);
}
}  // namespace wheel_rail_contact::core
