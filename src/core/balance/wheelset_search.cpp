// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheelset_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/balance/grid_levels.h"
#include "core/balance/tuning.h"
#include "core/constants.h"
#include "core/track/root_bracket.h"

namespace wheel_rail_contact::core
{
namespace
{
using Input = WheelEquilibrium::Input;
using Output = WheelEquilibrium::Output;

constexpr double finest_bracket = 1e-9;     ///< width at which a bracket without a zero ends the search [rad]
constexpr double roll_limit = 0.2;          ///< [rad]
constexpr double unloaded_accuracy = 1e-7;  ///< of the height of a wheel without load [m]
/// Changes of loads below this part of the whole load count as of it: the residual of the solutions causes as much [-].
constexpr double least_share =
    tuning::residual_per_tolerance / tuning::opening_per_tolerance * WheelLoads::overlap_per_load;
constexpr double linear_turn = 0.1;   ///< largest roll to which an opening is linear, over the largest step [-]
constexpr double least_slope = 1e-6;  ///< of the height difference over the roll, < 0: a stable wheelset [m/rad]
}  // namespace

WheelsetSearch::WheelsetSearch(const ContactModelConfig& config, NormalSolver& solver)
    : config_(config),
      accuracy_(tuning::opening_per_tolerance * searchTolerance(config)),
      greatest_turn_(tuning::longest_step / config.wheelset.meanRadius()),
      wheels_([&](Side side) { return WheelEquilibrium(config, side, solver, accuracy_); })
{
}

void WheelsetSearch::reset(double roll)
{
  start_roll_ = roll;
  warm_ = false;
  for (const Side side : sides)
  {
    wheels_[side].reset();
  }
}

void WheelsetSearch::begin(const WheelsetState& state, bool keeps_grids)
{
  const WheelsetState before = std::exchange(state_, state);
  const double tilt = tiltOf(state.rail_displacement, config_.wheelset.halfBase());
  keeps_grids_ = keeps_grids;
  loads_ = WheelLoads(config_.wheelset, state);
  for (const Side side : sides)
  {
    wheels_[side].setRail(state.rail_lateral_force[side], state.rail_displacement[side]);
  }
  solved_ = {};
  open_ = 0;
  const bool warm = std::exchange(warm_, true);
  if (!config_.wheelset.solve_height_and_roll)
  {
    z_ = state.z;
    place_.roll = state.roll;
    return;
  }
  z_ = warm ? z_ : config_.wheelset.meanRadius();
  place_.heights = z_;
  if (warm)
  {
    follow(before);
    return;
  }
  place_.roll = start_roll_ + tilt;
  place_.loads = loads_.given();
}

/// Follows the movements of wheelset and rails and the change of the loads since the state `before`.
void WheelsetSearch::follow(const WheelsetState& before)
{
  const double half_base = config_.wheelset.halfBase();
  Step step;
  step.loads = loads_.balances() ? loads_.with(0.5 * (place_.loads.right - place_.loads.left)) : loads_.given();
  step.roll = tiltOf(state_.rail_displacement, half_base) - tiltOf(before.rail_displacement, half_base);
  for (const Side side : sides)
  {
    WheelEquilibrium& wheel = wheels_[side];
    const RailDeflection &rail = state_.rail_displacement[side], &rail_before = before.rail_displacement[side];
    const double outward = sideSign(side) * (state_.y - before.y) - (rail.lateral - rail_before.lateral);
    place_.heights[side] += wheel.rate(Output::height_rate, Input::by_lateral) * outward + rail.vertical -
                            rail_before.vertical + wheel.heightPerRailRoll() * (rail.roll - rail_before.roll);
    place_.moments[side] += wheel.rate(Output::moment_rate, Input::by_lateral) * outward;
    wheel.predict(outward, 0, 0);
  }
  move(step);
  move(newton());
}

double WheelsetSearch::sumOfRates(Output output, Input input) const
{
  return wheels_.left.rate(output, input) + wheels_.right.rate(output, input);
}

/// The Newton step that closes heights and moments.
WheelsetSearch::Step WheelsetSearch::newton() const
{
  const double per_roll = sumOfRates(Output::height_rate, Input::by_roll);
  Step step;
  step.difference = heightDifference();
  step.slope = per_roll;
  if (loads_.areCoupled(place_.loads))
  {
    // The loads that close the heights change the moment. Written as a height, at the usual lever arms.
    const double base = 2 * config_.wheelset.halfBase();
    const double height = -sumOfRates(Output::height_rate, Input::by_load) / base;
    const double lever = sumOfRates(Output::moment_rate, Input::by_load) / base;
    step.difference = lever * heightDifference() + height * loads_.openMoment(place_.moments);
    step.slope = lever * per_roll + height * sumOfRates(Output::moment_rate, Input::by_roll);
  }
  step.slope = std::min(step.slope, -least_slope);
  step.roll = std::clamp(-step.difference / step.slope, -greatest_turn_, greatest_turn_);
  step.loads = loadsAfter(step.roll);
  return step;
}

/// Loads that close the heights after a roll [rad], if the moments determine them.
Sides<double> WheelsetSearch::loadsAfter(double roll) const
{
  if (!loads_.areCoupled(place_.loads))
  {
    return place_.loads;
  }
  const double difference = heightDifference() + sumOfRates(Output::height_rate, Input::by_roll) * roll;
  return loads_.changed(place_.loads, difference / sumOfRates(Output::height_rate, Input::by_load));
}

/// Changes roll and loads, and heights and deflections as they follow.
void WheelsetSearch::move(const Step& step)
{
  for (const Side side : sides)
  {
    WheelEquilibrium& wheel = wheels_[side];
    const double roll = sideSign(side) * step.roll, load = place_.loads[side];
    place_.heights[side] += wheel.rate(Output::height_rate, Input::by_roll) * roll;
    if (load > 0 && wheel.loaded())
    {
      const double overlap = std::pow(step.loads[side] / load, WheelLoads::overlap_per_load) - 1;
      place_.heights[side] +=
          wheel.rate(Output::height_rate, Input::by_load) * load * overlap / WheelLoads::overlap_per_load;
    }
    place_.moments[side] += wheel.rate(Output::moment_rate, Input::by_roll) * roll +
                            wheel.rate(Output::moment_rate, Input::by_load) * (step.loads[side] - load);
    wheel.predict(0, roll, step.loads[side] - load);
  }
  place_.loads = step.loads;
  place_.roll += step.roll;
  z_ = 0.5 * (place_.heights.left + place_.heights.right);
}

/// Largest opening of the gap of a wheel by a roll [rad] and a load [N] other than those of its last solution, over its
/// overlap [-]. Infinite beyond a roll at which it is not linear.
double WheelsetSearch::openingAt(Side side, double roll, double load) const
{
  const WheelEquilibrium& wheel = wheels_[side];
  if (!wheel.loaded())
  {
    return 0;
  }
  const Solved& solved = *solved_[side];
  const double turn = sideSign(side) * (roll - solved.roll), change = load - solved.load;
  return (std::abs(turn) > linear_turn * greatest_turn_ ? infinity : wheel.opening(turn, change)) +
         WheelLoads::overlap_per_load * std::abs(change) / std::max(solved.load, least_share * loads_.sum());
}

/// Solves the wheels at the roll under the loads, as far as they are not. Sets `any` to true if it solved one.
WheelStatus WheelsetSearch::solveWheels(const KeptResult& kept, bool& any)
{
  for (const Side side : sides)
  {
    WheelEquilibrium& wheel = wheels_[side];
    // Both loads add up to that of the wheelset only if both wheels are solved for the same ones.
    if (solved_[side] && wheel.loaded() && place_.loads[side] == solved_[side]->load &&
        openingAt(side, place_.roll, place_.loads[side]) <= accuracy_)
    {
      continue;
    }
    const WheelStatus status =
        wheel.solveUnderLoad(toSide(side, {state_.y, place_.heights[side], state_.yaw, place_.roll}),
                             place_.loads[side], {keeps_grids_ || (kept.grids && solved_[side]), kept.response});
    if (!isUsable(status))
    {
      return status;
    }
    place_.heights[side] = wheel.height();
    place_.moments[side] = wheel.moment();
    solved_[side] = Solved{place_.roll, place_.loads[side]};
    any = true;
  }
  return WheelStatus::solved;
}

/// Difference of the heights, left minus right [m].
double WheelsetSearch::heightDifference() const
{
  return place_.heights.left - place_.heights.right;
}

/// True if a step hardly changes the contacts, and no wheel lifts in it. Takes it then.
bool WheelsetSearch::closes(const Step& step, double share)
{
  lifts_ = loads_.areLifted(place_.loads);
  const double smaller = std::max(std::min(place_.loads.left, place_.loads.right), least_share * loads_.sum());
  const double acceptable = tuning::jump_share * accuracy_ * smaller / WheelLoads::overlap_per_load;
  bool closed = std::abs(step.difference / step.slope) <= greatest_turn_ &&
                (!loads_.areCoupled(place_.loads) ||
                 std::abs(loads_.openMoment(place_.moments)) <= 2 * config_.wheelset.halfBase() * acceptable);
  for (const Side side : sides)
  {
    open_[side] = openingAt(side, place_.roll + step.roll, step.loads[side]);
    closed = closed && open_[side] <= share * accuracy_ && (step.loads[side] > 0) == (place_.loads[side] > 0);
  }
  const bool at_rest = !wheels_.left.loaded() && !wheels_.right.loaded();
  if (!closed || (at_rest && std::abs(heightDifference()) > unloaded_accuracy))
  {
    return false;
  }
  move(step);
  return true;
}

/// Shortens a step that moves more than half of the larger load to the other wheel: it is linear, and overlaps are not.
/// The wheel with the smaller load may lift.
void WheelsetSearch::shorten(Step& step) const
{
  const double change = std::abs(step.loads.right - place_.loads.right);
  const double share = 0.5 * std::max(place_.loads.left, place_.loads.right) / change;
  if (share < 1)
  {
    step.roll *= share;
    step.loads = WheelLoads::between(place_.loads, step.loads, share);
  }
}

/// True if a change of the roll by this much does not matter. Between two such rolls, only the grids change.
bool WheelsetSearch::isNarrow(double range) const
{
  return range < finest_bracket ||
         std::all_of(sides.begin(), sides.end(),
                     [&](Side side) { return wheels_[side].loaded() && wheels_[side].opening(range, 0) < accuracy_; });
}

/// Uncertainty of the difference of a step [m]: by the solutions, and by the loads that would close it, because the
/// step is linear and the overlaps are not. Loads change heights by about the overlaps at most. Where the heights
/// differ by more, the sign of the difference is known, and a step with the other sign is wrong.
double WheelsetSearch::uncertainty(const Step& step) const
{
  double sum = 0, overlaps = 0;
  for (const Side side : sides)
  {
    const double overlap = wheels_[side].loaded() ? wheels_[side].contact().overlap() : 0;
    sum += wheels_[side].loaded() ? tuning::last_step * tuning::last_step * overlap : unloaded_accuracy;
    overlaps += overlap;
  }
  if (!loads_.areCoupled(place_.loads))
  {
    return sum;
  }
  const double difference = heightDifference();
  const double transfer = difference / sumOfRates(Output::height_rate, Input::by_load);
  const double by_loads = std::abs(difference * transfer) / std::min(place_.loads.left, place_.loads.right);
  if (step.difference * difference > 0)
  {
    return sum + std::min(by_loads, overlaps);
  }
  return std::abs(difference) > overlaps ? infinity : sum + by_loads;
}

/// Goes half of the way back to an earlier place. Both wheels are solved again: their heights are those of that place.
void WheelsetSearch::retreat(const Place& earlier)
{
  place_.roll = 0.5 * (place_.roll + earlier.roll);
  place_.loads = WheelLoads::between(place_.loads, earlier.loads, 0.5);
  place_.heights = earlier.heights;
  solved_ = {};
}

/// Loads a wheel that returns to its rail as the open moment requires, if it is near its rail.
bool WheelsetSearch::takesLoad()
{
  const Side lifted = WheelLoads::lifted(place_.loads);
  Step step = newton();
  step.loads = loads_.with(lifted, std::abs(loads_.openMoment(place_.moments)) / (2 * config_.wheelset.halfBase()));
  if (std::abs(heightDifference()) > wheels_[lifted].contact().typicalOverlap(step.loads[lifted]))
  {
    return false;
  }
  move(step);
  return true;
}

/// True if the Newton step ends the search, which it does not while a wheel returns to its rail. Computes the stiffness
/// if it is required for the step.
bool WheelsetSearch::ends(Step& step, Start start, bool returning)
{
  const bool known = wheels_.left.responded() && wheels_.right.responded();
  if (!returning && closes(step, start == Start::other_grids ? tuning::jump_share : known ? 1 : tuning::unknown_share))
  {
    return true;
  }
  if (known)
  {
    return false;
  }
  wheels_.left.respond();
  wheels_.right.respond();
  step = newton();
  return !returning && closes(step, 1);
}

WheelStatus WheelsetSearch::solve(Start start)
{
  RootBracket bracket;
  std::optional<Place> last;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    const bool coupled = loads_.areCoupled(place_.loads), is_early = i < tuning::early_solutions;
    bool any_solved = false;
    const KeptResult kept{!is_early, is_early && start != Start::other_state};
    if (const WheelStatus status = solveWheels(kept, any_solved); !isUsable(status))
    {
      if (!last || i + 1 == tuning::most_solutions)
      {
        return status;
      }
      retreat(*last);
      continue;
    }
    last = place_;
    const double ignored = i < tuning::most_solutions / 2 ? 0 : 0.5 * tuning::jump_share * accuracy_;
    const bool returning = loads_.returnWheel(place_.loads, place_.moments, ignored);
    if (returning && takesLoad())
    {
      bracket = {};
      continue;
    }
    Step step = newton();
    if (ends(step, start, returning))
    {
      return WheelStatus::solved;
    }
    if (std::abs(step.difference) > uncertainty(step))
    {
      if (!kept.response)  // derivatives of another state may have the wrong sign
      {
        bracket.add(place_.roll, step.difference);
      }
    }
    else if (!returning && closes(step, tuning::jump_share))
    {
      return WheelStatus::solved;
    }
    if ((std::isfinite(bracket.width()) && isNarrow(bracket.width())) || !any_solved)
    {
      return !returning && closes(step, tuning::jump_share) ? WheelStatus::solved : WheelStatus::unbalanced;
    }
    step.roll = bracket.next(place_.roll, step.roll) - place_.roll;
    step.loads = loadsAfter(step.roll);
    shorten(step);
    move(step);
    if (loads_.areCoupled(place_.loads) != coupled)
    {
      bracket = {};
    }
    if (!(std::abs(place_.roll) < roll_limit))
    {
      return WheelStatus::unbalanced;
    }
  }
  return WheelStatus::unbalanced;
}

WheelStatus WheelsetSearch::solveAtGivenHeight()
{
  for (const Side side : sides)
  {
    if (solved_[side])
    {
      continue;
    }
    const WheelStatus status =
        wheels_[side].solveAtPose(toSide(side, {state_.y, z_, state_.yaw, place_.roll}), {keeps_grids_, false});
    if (!isUsable(status))
    {
      return status;
    }
    solved_[side] = Solved{place_.roll, 0};
  }
  return WheelStatus::solved;
}
}  // namespace wheel_rail_contact::core
