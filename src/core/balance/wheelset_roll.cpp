// SPDX-License-Identifier: BSD-3-Clause
// Placement of the wheelset and search for its roll. The other members of WheelsetBalance are in wheelset_balance.cpp.
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
/// Allowed difference of the axle heights of both sides in the search for the roll, per unit of contact/tolerance [m].
constexpr double height_per_tolerance = 1e-5;
/// The same in the first pass: a tenth of the roll error that a result may have, which is corrected to first order.
constexpr double first_height_per_tolerance = 5e-5;
}  // namespace

/// Pose of the state at a given roll, in side axes, without height.
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

/// Finds the roll at which both wheels give the same axle height with the present penetrations: the height from the
/// left wheel decreases with the roll, that from the right wheel increases. Newton steps, kept within the present
/// bracket.
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

/// First touch of a cold start. A compliant rail may be moved outward from under the flange.
bool WheelsetBalance::touchFirst()
{
  if (!touchBoth(roll_))
  {
    return false;
  }
  for (const Side side : sides)
  {
    const std::size_t k = index(side);
    touch_[k] = rail_[k].clearFlange(touch_[k], poseOf(side, roll_), load_[k]);
  }
  return touch_[0].found && touch_[1].found;
}

/// Predicts the roll after a lateral displacement [m] from the last contacts. If a contact tilts(), rigid contact gives
/// no better prediction, and the secant takes over from this roll.
void WheelsetBalance::predictRoll(double moved)
{
  double slope = 0;
  bool tilts = false;
  for (const Side side : sides)
  {
    slope += loaded_[index(side)] ? wheel_[index(side)].heightSlope() : touch_[index(side)].contact.slope;
    tilts = tilts || (loaded_[index(side)] && wheel_[index(side)].tilts());
  }
  const double levers = std::max(leverSum(), RollSecant::least_fall);
  roll_ += std::clamp(slope * moved / levers, -roll_step_limit, roll_step_limit);
  if (tilts)
  {
    secant_.start(roll_, levers);
  }
}

/// Places the wheelset for the next pass.
bool WheelsetBalance::place(bool first)
{
  if (!config_.wheelset.solve_height_and_roll)
  {
    return touchBoth(roll_);
  }
  if (secant_.takesOver())  // the roll does not change while planes and boxes do not fit
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
