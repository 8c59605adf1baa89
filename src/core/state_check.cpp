// SPDX-License-Identifier: BSD-3-Clause
#include "core/state_check.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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

/// True for displacements or velocities of both rails that are within the limits.
template <typename Rail>
bool within(const Sides<Rail>& rails, double shift, double turn)
{
  return std::all_of(sides.begin(), sides.end(),
                     [&](Side side)
                     {
                       return within(rails[side].lateral, shift) && within(rails[side].vertical, shift) &&
                              within(rails[side].roll, turn);
                     });
}
}  // namespace

std::string_view faultOf(const WheelsetState& state, bool height_and_roll_given)
{
  const auto& force = state.rail_lateral_force;
  const bool has_roll = !height_and_roll_given || !std::isnan(state.roll);
  const std::pair<bool, std::string_view> rules[] = {
      {std::isfinite(state.y), "lateral position is not a number"},
      {has_roll && !(std::abs(state.roll) > angle_limit), "roll is not a number or beyond 0.2 rad"},
      {within(state.yaw, angle_limit), "yaw is not a number or beyond 0.2 rad"},
      {std::isfinite(state.pitch), "pitch is not a number"},
      {within(state.force_z, force_limit) && within(state.torque_x, force_limit),
       "load is not a number or beyond 1e8 N"},
      {within(force.left, force_limit) && within(force.right, force_limit),
       "lateral rail force is not a number or beyond 1e8 N"},
      {within(state.rail_displacement, displacement_limit, angle_limit),
       "displacement of a rail is not a number or beyond 0.1 m or 0.2 rad"},
      {within(state.rail_velocity, speed_limit, rate_limit),
       "velocity of a rail is not a number or beyond 1000 m/s or 10000 rad/s"},
      {within(state.motion), "a velocity of the axle is not a number or beyond 1000 m/s or 10000 rad/s"},
      {!height_and_roll_given || within(state.z, height_limit), "height is not a number or beyond 1 m"}};
  const auto* const broken =
      std::find_if(std::begin(rules), std::end(rules), [](const auto& rule) { return !rule.first; });
  return broken == std::end(rules) ? std::string_view() : broken->second;
}

std::string loadDoubt(double mean, const WheelsetConfig& wheelset)
{
  const double scale = wheelset.meanRadius() / WheelsetConfig().meanRadius(), least = least_load * scale * scale;
  return mean <= -least ? formatted(
                              "the mean wheel load is %.4g kN, upward: force.z and loads as "
                              "reactions have the other sign",
                              1e-3 * mean)
         : mean < least
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
