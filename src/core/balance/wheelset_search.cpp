// SPDX-License-Identifier: BSD-3-Clause
// Search of WheelsetBalance for loads, roll and height.
#include <algorithm>
#include <cmath>

#include "core/balance/tuning.h"
#include "core/balance/wheelset_balance.h"
#include "core/constants.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double finest_bracket = 1e-9;       ///< width at which a bracket without a zero ends the search [rad]
constexpr double roll_limit = 0.2;            ///< [rad]
constexpr double least_load = 0.1;            ///< smaller wheel loads are taken as zero: no overlap resolves them [N]
constexpr double unloaded_accuracy = 1e-7;    ///< of the height of a wheel without load [m]
constexpr double overlap_per_load = 2.0 / 3;  ///< relative change of the overlap per one of the load, Hertz [-]
constexpr double least_share = 1e-3;          ///< loads below this part of the whole load count as it [-]
}  // namespace

/// Sets the loads of both wheels. With WheelsetConfig::Balance::moments, these are the first ones of a search: those
/// that balance the moments at the lever arms of the last result.
void WheelsetBalance::beginTransfer()
{
  const double base = 2 * config_.wheelset.halfBase(), load = std::max(-state_.force_z, 0.0);
  if (balances_moments_)
  {
    const double left = warm_ ? leverOf(Side::left) : 0.5 * base, right = warm_ ? leverOf(Side::right) : 0.5 * base;
    transfer_.begin(load, state_.torque_x, left + right, left - right);
    distribute(load, transfer_.transfer());
    return;
  }
  distribute(-state_.force_z, state_.torque_x / base);
}

/// Lever arm of a wheel: the moment of its contact, positive if it lifts the wheel, over its load [m].
double WheelsetBalance::leverOf(Side side) const
{
  const WheelEquilibrium& wheel = wheels_[side];
  const bool known = wheel.loaded() && loads_[side] > 0;
  return known ? wheel.moment() / loads_[side] : config_.wheelset.halfBase();
}

/// Sets the wheel loads: half of the sum [N], of which `transfer` [N] moves from the left to the right wheel.
void WheelsetBalance::distribute(double sum, double transfer)
{
  for (const Side side : sides)
  {
    const double load = 0.5 * sum - sideSign(side) * transfer;
    loads_[side] = load > least_load ? load : 0;
    solved_[side] = false;
  }
}

/// Finds height and roll under the loads, and with WheelsetConfig::Balance::moments also the loads.
WheelStatus WheelsetBalance::balanceLoads()
{
  const double sum = -state_.force_z;
  if (!balances_moments_ || !(sum > least_load))
  {
    return search();
  }
  transfer_.widen();
  double roll = roll_;
  Sides<double> heights = heights_;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    const WheelStatus status = search();
    LoadTransfer::Step step = LoadTransfer::Step::failed;
    if (isUsable(status))
    {
      roll = roll_;
      heights = heights_;
      step = advanceTransfer(sum);
    }
    else
    {
      roll_ = roll;
      heights_ = heights;
      step = transfer_.retreat();
    }
    if (step != LoadTransfer::Step::moved)
    {
      return step == LoadTransfer::Step::closed || !isUsable(status) ? status : WheelStatus::unbalanced;
    }
    distribute(sum, transfer_.transfer());
  }
  return WheelStatus::unbalanced;
}

/// Takes the last solution under the sum of the loads [N], and chooses the next transfer. Where the forces jump because
/// the grid changes, the moment stays open by as much.
LoadTransfer::Step WheelsetBalance::advanceTransfer(double sum)
{
  const double open = state_.torque_x + (wheels_.left.moment() - wheels_.right.moment());
  const double smaller = std::max(std::min(loads_.left, loads_.right), least_share * sum);
  const double accuracy = accuracy_ * smaller / overlap_per_load;
  return transfer_.advance(open, leverOf(Side::left) + leverOf(Side::right), accuracy,
                           2 * config_.wheelset.halfBase() * tuning::jump_share * accuracy);
}

WheelStatus WheelsetBalance::solveAtGivenHeight()
{
  open_ = 0;
  for (const Side side : sides)
  {
    if (solved_[side])
    {
      continue;
    }
    const WheelStatus status = wheels_[side].solveAtPose(toSide(side, {state_.y, z_, state_.yaw, roll_}), accuracy_);
    if (!isUsable(status))
    {
      return status;
    }
    solved_[side] = unestimated_[side] = true;
  }
  return WheelStatus::solved;
}

/// Depth of the given height below that of first touch, of the wheel that is less deep [m]. A wrong lateral position
/// lets only one wheel overlap its rail. After a failure, the positions of first touch replace the last solutions.
double WheelsetBalance::depthOfHeight(WheelStatus status)
{
  double depth = infinity;
  for (const Side side : sides)
  {
    WheelEquilibrium& wheel = wheels_[side];
    const WheelsetPose above{state_.y, config_.wheelset.meanRadius(), state_.yaw, state_.roll};
    if (isUsable(status))
    {
      depth = std::min(depth, wheel.loaded() ? wheel.contact().overlap() : 0);
    }
    else
    {
      const bool touches = isUsable(wheel.solveUnderLoad(toSide(side, above), 0, accuracy_, false));
      depth = std::min(depth, touches ? wheel.height() - state_.z : 0);
    }
  }
  return depth;
}

/// True if a wheel must be solved again because the roll has changed its contact.
bool WheelsetBalance::isMoved(Side side) const
{
  const double turned = roll_ - solved_roll_[side];
  return !solved_[side] || !wheels_[side].loaded() || openedBy(side, turned) > accuracy_;
}

/// Largest opening of the gap of a wheel by a roll [rad] under the same load, over its overlap [-].
double WheelsetBalance::openedBy(Side side, double roll) const
{
  const WheelEquilibrium& wheel = wheels_[side];
  return wheel.loaded() ? wheel.openingPerRoll() * std::abs(roll) / wheel.contact().overlap() : 0;
}

/// Solves the wheels at the roll, as far as they are not.
WheelStatus WheelsetBalance::solveMovedWheels(bool keep_grids)
{
  any_solved_ = false;
  for (const Side side : sides)
  {
    if (!isMoved(side))
    {
      continue;
    }
    const WheelStatus status = wheels_[side].solveUnderLoad(toSide(side, {state_.y, heights_[side], state_.yaw, roll_}),
                                                            loads_[side], accuracy_, keep_grids && solved_[side]);
    if (!isUsable(status))
    {
      return status;
    }
    heights_[side] = wheels_[side].height();
    solved_[side] = unestimated_[side] = any_solved_ = true;
    solved_roll_[side] = roll_;
  }
  return WheelStatus::solved;
}

/// Slope of the difference of the heights over the roll [m/rad].
double WheelsetBalance::updateSlopes()
{
  for (const Side side : sides)
  {
    slopes_[side] = sideSign(side) * wheels_[side].heightPerRoll();
  }
  return std::min(slopes_.left - slopes_.right, tuning::flattest_slope);
}

/// Changes the roll, and heights and deflections as they follow.
void WheelsetBalance::turn(double roll)
{
  for (const Side side : sides)
  {
    heights_[side] += slopes_[side] * (roll - roll_);
    wheels_[side].predict(0, sideSign(side) * (roll - roll_));
  }
  roll_ = roll;
  z_ = 0.5 * (heights_.left + heights_.right);
}

/// True if the roll that closes the difference of the heights [m] hardly changes the contacts. Turns the wheelset to
/// it.
bool WheelsetBalance::closeDifference(double difference, double share)
{
  const double closed = roll_ - difference / updateSlopes();
  const double limit = share * accuracy_;
  for (const Side side : sides)
  {
    open_[side] = openedBy(side, closed - solved_roll_[side]);
  }
  const bool at_rest = !wheels_.left.loaded() && !wheels_.right.loaded() && std::abs(difference) > unloaded_accuracy;
  if (at_rest || !(std::max(open_.left, open_.right) <= limit) || !(std::abs(closed - roll_) <= greatest_turn_))
  {
    return false;
  }
  turn(closed);
  return true;
}

/// True if a change of the roll by this much does not matter. Between two such rolls, only the grids change.
bool WheelsetBalance::isNarrow(double range) const
{
  return std::all_of(sides.begin(), sides.end(),
                     [&](Side side)
                     {
                       const WheelEquilibrium& wheel = wheels_[side];
                       return range < finest_bracket || (wheel.loaded() && wheel.openingPerRoll() * range <
                                                                               accuracy_ * wheel.contact().overlap());
                     });
}

WheelStatus WheelsetBalance::search()
{
  double least = -infinity, most = infinity;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    if (i >= tuning::early_solutions)
    {
      wheels_.left.keepResponse(false);
      wheels_.right.keepResponse(false);
    }
    if (const WheelStatus status = solveMovedWheels(i >= tuning::early_solutions); !isUsable(status))
    {
      return status;
    }
    const double difference = heights_.left - heights_.right;
    const bool known = wheels_.left.responded() && wheels_.right.responded();
    // Other grids at the same place: the heights differ by the errors of the grids.
    if (closeDifference(difference, own_grids_required_ ? tuning::jump_share : known ? 1 : tuning::unknown_share))
    {
      return WheelStatus::solved;
    }
    wheels_.left.respond();
    wheels_.right.respond();
    if (!known && closeDifference(difference, 1))
    {
      return WheelStatus::solved;
    }
    double uncertain = 0;
    for (const Side side : sides)
    {
      uncertain += wheels_[side].loaded() ? tuning::noise * wheels_[side].contact().overlap() : unloaded_accuracy;
    }
    if (std::abs(difference) > uncertain)
    {
      (difference > 0 ? least : most) = roll_;
    }
    double next = roll_ + std::clamp(-difference / updateSlopes(), -greatest_turn_, greatest_turn_);
    if (!(next > least && next < most))
    {
      const bool bracketed = std::isfinite(least) && std::isfinite(most);
      next = 0.5 * (bracketed ? least + most : roll_ + (next > least ? most : least));
    }
    if (isNarrow(most - least) || !any_solved_)
    {
      return closeDifference(difference, tuning::jump_share) ? WheelStatus::solved : WheelStatus::unbalanced;
    }
    turn(next);
    if (!(std::abs(roll_) < roll_limit))
    {
      return WheelStatus::unbalanced;
    }
  }
  return WheelStatus::unbalanced;
}
}  // namespace wheel_rail_contact::core
