// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheelset_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/balance/tuning.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr double finest_bracket = 1e-9;     ///< width at which a bracket without a zero ends the search [rad]
constexpr double roll_limit = 0.2;          ///< [rad]
constexpr double least_load = 1e-9;         ///< smaller loads are taken as zero [N]
constexpr double unloaded_accuracy = 1e-7;  ///< of the height of a wheel without load [m]

bool isUsable(WheelStatus status)
{
  return status == WheelStatus::solved || status == WheelStatus::no_contact;
}
}  // namespace

WheelsetBalance::WheelsetBalance(const ContactModelConfig& config, const GridLevels& levels)
    : config_(config),
      levels_(levels),
      accuracy_(tuning::opening_per_tolerance * config.contact.tolerance),
      greatest_turn_(tuning::longest_step / config.wheelset.meanRadius()),
      wheels_{WheelOnRail(config, Side::left, levels.solver()), WheelOnRail(config, Side::right, levels.solver())}
{
}

void WheelsetBalance::reset(double roll)
{
  start_roll_ = roll;
  warm_ = false;
  for (WheelOnRail& wheel : wheels_)
  {
    wheel.reset();
  }
}

int WheelsetBalance::count() const
{
  return wheels_[0].contact().solutions() + wheels_[1].contact().solutions();
}

ContactStatus WheelsetBalance::fail(WheelStatus status)
{
  SolveStatus normal_status = SolveStatus::stalled;
  for (const WheelOnRail& wheel : wheels_)
  {
    if (const SolveStatus of_wheel = wheel.contact().solution().status; !core::isUsable(of_wheel))
    {
      normal_status = of_wheel;
      break;
    }
  }
  reset();
  switch (status)
  {
    case WheelStatus::beside_rail:
      reason_ = "a wheel is beside its rail";
      return ContactStatus::off_profile;
    case WheelStatus::normal_failed:
      reason_ = toString(normal_status);
      return ContactStatus::not_converged;
    default:
      reason_ = "no balance of height, roll and rail deflection was found";
      return ContactStatus::not_converged;
  }
}

ContactStatus WheelsetBalance::solve(const WheelsetState& state)
{
  const int solved_before = count();
  const bool given = !config_.wheelset.solve_height_and_roll;
  const double transfer = 0.5 * state.torque_x / config_.wheelset.halfBase();
  const WheelsetState before = state_;
  state_ = state;
  placeOnLine();
  z_ = given ? state.z : warm_ ? z_ : config_.wheelset.meanRadius();
  roll_ = given ? state.roll : warm_ ? roll_ : start_roll_ + tilt(state_);
  reason_ = {};
  laid_ = false;
  heights_.fill(z_);
  if (warm_ && !given)
  {
    predict(before);
  }
  for (const Side side : sides)
  {
    const double load = -0.5 * state.force_z - sideSign(side) * transfer;
    loads_[index(side)] = load > least_load ? load : 0;
    setLevel(index(side), 0);
    wheels_[index(side)].setRail(state.rail_lateral_force[index(side)], state_.rail_displacement[index(side)]);
  }
  WheelStatus status = WheelStatus::solved;
  do
  {
    status = given ? hold() : search();
  } while (isUsable(status) && (layOwnGrids() || refine()));
  solutions_ = count() - solved_before;
  if (!isUsable(status))
  {
    return fail(status);
  }
  if (wheels_[0].contact().reachesEnd() || wheels_[1].contact().reachesEnd())
  {
    reset();
    reason_ = "contact lies beyond the end of a profile";
    return ContactStatus::off_profile;
  }
  warm_ = true;
  return wheels_[0].loaded() && wheels_[1].loaded() ? ContactStatus::ok : ContactStatus::lift_off;
}

/// Moves both rails to the place of the state on the line. Adds the displacement by the line to that of the state.
void WheelsetBalance::placeOnLine()
{
  for (WheelOnRail& wheel : wheels_)
  {
    wheel.moveTo(state_.distance);
  }
  if (const TrackLine* line = config_.track.line.get())
  {
    const std::array<RailDeflection, 2> displaced =
        displacementsAt(line->at(state_.distance),
                        {wheels_[0].restingRail().referencePoint(), wheels_[1].restingRail().referencePoint()});
    state_.rail_displacement[0] += displaced[0];
    state_.rail_displacement[1] += displaced[1];
  }
}

/// Predicts heights and roll from the last contacts, after the movements of wheelset and rails since the state
/// `before`.
void WheelsetBalance::predict(const WheelsetState& before)
{
  for (const Side side : sides)
  {
    const auto k = index(side);
    const RailDeflection &rail = state_.rail_displacement[k], &rail_before = before.rail_displacement[k];
    const double outward = sideSign(side) * (state_.y - before.y) - (rail.lateral - rail_before.lateral);
    heights_[k] += wheels_[k].heightPerLateral() * outward + rail.vertical - rail_before.vertical +
                   wheels_[k].heightPerRailRoll() * (rail.roll - rail_before.roll);
    wheels_[k].predict(outward, 0);
  }
  updateSlopes();
  turn(roll_ + tilt(state_) - tilt(before));
  const double step = -(heights_[0] - heights_[1]) / updateSlopes();
  turn(roll_ + std::clamp(step, -greatest_turn_, greatest_turn_));
}

WheelStatus WheelsetBalance::hold()
{
  open_.fill(0);
  for (const Side side : sides)
  {
    const auto k = index(side);
    if (solved_[k])
    {
      continue;
    }
    const WheelStatus status = wheels_[k].hold(toSide(side, {state_.y, z_, state_.yaw, roll_}), accuracy_);
    if (!isUsable(status))
    {
      return status;
    }
    solved_[k] = fresh_[k] = true;
  }
  return WheelStatus::solved;
}

/// True if a wheel must be solved again because the roll has changed its contact.
bool WheelsetBalance::isMoved(std::size_t k) const
{
  const double turned = roll_ - solved_roll_[k];
  return !solved_[k] || !wheels_[k].loaded() || openedBy(k, turned) > accuracy_;
}

/// Largest opening of the gap of a wheel by a roll [rad] under the same load, over its overlap [-].
double WheelsetBalance::openedBy(std::size_t k, double roll) const
{
  const WheelOnRail& wheel = wheels_[k];
  return wheel.loaded() ? wheel.openingPerRoll() * std::abs(roll) / wheel.contact().overlap() : 0;
}

/// Solves the wheels at the roll, as far as they are not.
WheelStatus WheelsetBalance::pass(bool keep_grids)
{
  any_solved_ = false;
  for (const Side side : sides)
  {
    const auto k = index(side);
    if (!isMoved(k))
    {
      continue;
    }
    const WheelStatus status = wheels_[k].carry(toSide(side, {state_.y, heights_[k], state_.yaw, roll_}), loads_[k],
                                                accuracy_, keep_grids && solved_[k]);
    if (!isUsable(status))
    {
      return status;
    }
    heights_[k] = wheels_[k].height();
    solved_[k] = fresh_[k] = any_solved_ = true;
    solved_roll_[k] = roll_;
  }
  return WheelStatus::solved;
}

/// Slope of the difference of the heights over the roll [m/rad].
double WheelsetBalance::updateSlopes()
{
  for (const Side side : sides)
  {
    slopes_[index(side)] = sideSign(side) * wheels_[index(side)].heightPerRoll();
  }
  return std::min(slopes_[0] - slopes_[1], tuning::flattest_slope);
}

/// Changes the roll, and heights and deflections as they follow.
void WheelsetBalance::turn(double roll)
{
  for (const Side side : sides)
  {
    const auto k = index(side);
    heights_[k] += slopes_[k] * (roll - roll_);
    wheels_[k].predict(0, sideSign(side) * (roll - roll_));
  }
  roll_ = roll;
  z_ = 0.5 * (heights_[0] + heights_[1]);
}

/// True if the roll that closes the difference of the heights [m] hardly changes the contacts. Turns the wheelset to
/// it.
bool WheelsetBalance::settle(double difference, double share)
{
  const double closed = roll_ - difference / updateSlopes();
  const double limit = share * accuracy_;
  for (std::size_t k = 0; k < 2; ++k)
  {
    open_[k] = openedBy(k, closed - solved_roll_[k]);
  }
  const bool at_rest = !wheels_[0].loaded() && !wheels_[1].loaded() && std::abs(difference) > unloaded_accuracy;
  if (at_rest || !(std::max(open_[0], open_[1]) <= limit) || !(std::abs(closed - roll_) <= greatest_turn_))
  {
    return false;
  }
  turn(closed);
  return true;
}

/// True if a change of the roll by this much does not matter. Between two such rolls, only the grids change.
bool WheelsetBalance::isNarrow(double range) const
{
  return std::all_of(wheels_.begin(), wheels_.end(),
                     [&](const WheelOnRail& wheel)
                     {
                       return range < finest_bracket || (wheel.loaded() && wheel.openingPerRoll() * range <
                                                                               accuracy_ * wheel.contact().overlap());
                     });
}

WheelStatus WheelsetBalance::search()
{
  double least = -infinity, most = infinity;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    for (std::size_t k = 0; k < 2 && i >= tuning::early_solutions; ++k)
    {
      wheels_[k].keepResponse(false);
    }
    if (const WheelStatus status = pass(i >= tuning::early_solutions); !isUsable(status))
    {
      return status;
    }
    const double difference = heights_[0] - heights_[1];
    const bool known = wheels_[0].responded() && wheels_[1].responded();
    // Other grids at the same place: the heights differ by the errors of the grids.
    if (settle(difference, laid_ ? tuning::jump_share : known ? 1 : tuning::unknown_share))
    {
      return WheelStatus::solved;
    }
    wheels_[0].respond();
    wheels_[1].respond();
    if (!known && settle(difference, 1))
    {
      return WheelStatus::solved;
    }
    double uncertain = 0;
    for (const WheelOnRail& wheel : wheels_)
    {
      uncertain += wheel.loaded() ? tuning::noise * wheel.contact().overlap() : unloaded_accuracy;
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
      return settle(difference, tuning::jump_share) ? WheelStatus::solved : WheelStatus::unbalanced;
    }
    turn(next);
    if (!(std::abs(roll_) < roll_limit))
    {
      return WheelStatus::unbalanced;
    }
  }
  return WheelStatus::unbalanced;
}

/// Estimates the errors of a wheel. Returns the error that the tolerance limits.
double WheelsetBalance::estimate(Side side)
{
  const auto k = index(side);
  const WheelContact& contact = wheels_[k].contact();
  islands_[k].find(contact.problem(), contact.solution());
  const NormalSolution& solution = islands_[k].solution();
  levels_.solver().estimateErrors(islands_[k].problem(), solution, errors_[k]);
  double highest = 0, area = 0, force = 0;
  for (const PatchPressure& patch : solution.patches)
  {
    highest = std::max(highest, patch.max_pressure);
    area += patch.area;
    force += patch.force;
  }
  double pressure_error = 0, area_error = 0, approach_error = 0;
  for (std::size_t i = 0; i < solution.patches.size(); ++i)
  {
    const PatchPressure& patch = solution.patches[i];
    const ErrorEstimate& error = errors_[k][i];
    // A lower peak counts by what it may rise above the highest one.
    const double above = patch.max_pressure < highest ? patch.max_pressure / highest - 1 : 0;
    pressure_error = std::max(pressure_error, above + error.max_pressure * patch.max_pressure / highest);
    area_error += error.area * patch.area / area;
    approach_error += error.approach * patch.force / force;
  }
  return std::max({pressure_error, area_error, approach_error});
}

/// Estimates the errors. Chooses finer grids where they exceed the tolerance. @return true if there are any
bool WheelsetBalance::refine()
{
  bool refined = false;
  for (const Side side : sides)
  {
    const auto k = index(side);
    if (fresh_[k])
    {
      wheel_errors_[k] = wheels_[k].loaded() ? estimate(side) : 0;
      fresh_[k] = false;
    }
    const std::size_t level = levels_.finer(level_[k], wheel_errors_[k]);
    if (level != level_[k])
    {
      wheels_[k].respond();
      setLevel(k, level);
      refined = true;
    }
  }
  return refined;
}

/// Has wheels solved again whose grids are not those of their final heights, so that the result does not depend on the
/// start of the search.
/// @return true if there are any; at most once on the same levels
bool WheelsetBalance::layOwnGrids()
{
  bool any = false;
  for (std::size_t k = 0; k < 2 && !laid_; ++k)
  {
    const bool others = wheels_[k].loaded() && !wheels_[k].contact().hasOwnGrids();
    solved_[k] = solved_[k] && !others;
    any = any || others;
  }
  laid_ = true;
  return any;
}

void WheelsetBalance::setLevel(std::size_t k, std::size_t level)
{
  level_[k] = level;
  wheels_[k].keepResponse(level > 0);
  laid_ = false;
  solved_[k] = false;
  wheels_[k].contact().setGrid(level, levels_.at(level));
}
}  // namespace wheel_rail_contact::core
