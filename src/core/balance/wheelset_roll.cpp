// SPDX-License-Identifier: BSD-3-Clause
// How the wheelset is placed and its roll found: the rest of WheelsetBalance stands in wheelset_balance.cpp.
#include <algorithm>
#include <cmath>

#include "core/balance/both_sides.h"
#include "core/balance/wheelset_balance.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr int most_roll_steps = 60;
constexpr double roll_limit = 0.2;        ///< [rad]
constexpr double roll_step_limit = 5e-3;  ///< [rad]
/// Difference of both axle ends' heights left open for each unit of contact/tolerance, in finding the roll [m].
constexpr double height_per_tolerance = 1e-5;
/// The same in the first pass: a tenth of the roll that an answer may leave open, which is made up for to first order.
constexpr double first_height_per_tolerance = 5e-5;
}  // namespace

/// The state's pose at a roll, seen from a side; its height is left open.
WheelsetPose WheelsetBalance::poseOf(Side side, double roll) const
{
  return toSide(side, {state_.y, 0, state_.yaw, roll});
}

bool WheelsetBalance::touchBoth(double roll)
{
  for (const Side side : sides)
  {
    touch_[index(side)] = wheel_[index(side)].touch(poseOf(side, roll));
  }
  return touch_[0].found && touch_[1].found;
}

double WheelsetBalance::heightDifference() const
{
  return (touch_[0].axle_height - penetration_[0]) - (touch_[1].axle_height - penetration_[1]);
}

/// The roll at which both axle ends agree, with the descents known so far: the height seen from the left falls with the
/// roll, that from the right rises. Newton's steps, kept within the bracket seen so far.
bool WheelsetBalance::findRoll(bool first)
{
  const double open = (first ? first_height_per_tolerance : height_per_tolerance) * config_.contact.tolerance;
  double low = -roll_limit;
  double high = roll_limit;
  for (int i = 0; i < most_roll_steps; ++i)
  {
    if (!touchBoth(roll_))
    {
      return false;
    }
    const double difference = heightDifference();
    if (std::abs(difference) < open || high - low < 1e-12)
    {
      return true;
    }
    (difference > 0 ? low : high) = roll_;
    const double levers = touch_[0].lever + touch_[1].lever;
    const double step = std::clamp(difference / levers, -roll_step_limit, roll_step_limit);
    const double next = roll_ + step;
    roll_ = levers > 0 && next > low && next < high ? next : 0.5 * (low + high);
  }
  return false;
}

/// First touch from cold, on rails that give way to a flange.
bool WheelsetBalance::touchFirst()
{
  if (!touchBoth(roll_))
  {
    return false;
  }
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    touch_[k] = rail_[k].letFlangeDown(touch_[k], poseOf(side, roll_), load_[k]);
  }
  return touch_[0].found && touch_[1].found;
}

/// Rolls the wheelset as its last contacts ask for after it has moved sideways [m]. Where the load is carried elsewhere
/// than at the first touch, rigid touch does not tell better, and the roll goes on from there.
void WheelsetBalance::foresee(double moved)
{
  double rise = 0;
  bool tilts = false;
  for (const Side side : sides)
  {
    rise += loaded_[index(side)] ? wheel_[index(side)].rise() : touch_[index(side)].contact.slope;
    tilts = tilts || (loaded_[index(side)] && wheel_[index(side)].tilts());
  }
  const double levers = std::max(leverSum(), RollSecant::least_fall);
  roll_ += std::clamp(rise * moved / levers, -roll_step_limit, roll_step_limit);
  if (tilts)
  {
    secant_.start(roll_, levers);
  }
}

/// Places the wheelset for the next pass, or the first one.
bool WheelsetBalance::place(bool first)
{
  if (!config_.wheelset.solve_height_and_roll)
  {
    return touchBoth(roll_);
  }
  if (secant_.takesOver())  // as long as planes and boxes do not fit, the roll stays
  {
    roll_ = secant_.roll();
    return touchBoth(roll_);
  }
  return findRoll(first);
}

double WheelsetBalance::lever(Side side) const
{
  return loaded_[index(side)] ? wheel_[index(side)].lever() : touch_[index(side)].lever;
}

double WheelsetBalance::leverSum() const
{
  return lever(Side::left) + lever(Side::right);
}
}  // namespace wheel_rail_contact::core
