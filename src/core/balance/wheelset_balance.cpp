// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheelset_balance.h"

#include <algorithm>

#include "core/balance/islands.h"
#include "core/balance/tuning.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double deepest_height = 0.01;  ///< of a given height below that of first touch [m]
}  // namespace

WheelsetBalance::WheelsetBalance(const ContactModelConfig& config, const GridLevels& levels)
    : config_(config),
      levels_(levels),
      accuracy_(tuning::opening_per_tolerance * config.contact.tolerance),
      balances_moments_(config.wheelset.balance == WheelsetConfig::Balance::moments),
      greatest_turn_(tuning::longest_step / config.wheelset.meanRadius()),
      wheels_([&](Side side) { return WheelEquilibrium(config, side, levels.solver()); })
{
}

void WheelsetBalance::reset(double roll)
{
  start_roll_ = roll;
  warm_ = false;
  for (const Side side : sides)
  {
    wheels_[side].reset();
  }
}

int WheelsetBalance::count() const
{
  return wheels_.left.contact().solutions() + wheels_.right.contact().solutions();
}

ContactStatus WheelsetBalance::fail(WheelStatus status)
{
  SolveStatus normal_status = SolveStatus::stalled;
  for (const Side side : sides)
  {
    if (const SolveStatus of_wheel = wheels_[side].contact().solution().status; !isUsable(of_wheel))
    {
      normal_status = of_wheel;
      break;
    }
  }
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
  const bool was_warm = warm_;
  ContactStatus status = solveOnce(state);
  if (status == ContactStatus::not_converged && was_warm)
  {
    status = solveOnce(state);
  }
  solutions_ = count() - solved_before;
  return status;
}

/// Solves from the last result. After a failure, the next call starts cold.
ContactStatus WheelsetBalance::solveOnce(const WheelsetState& state)
{
  const bool given = !config_.wheelset.solve_height_and_roll;
  const WheelsetState before = state_;
  state_ = state;
  placeOnLine();
  z_ = given ? state.z : warm_ ? z_ : config_.wheelset.meanRadius();
  roll_ = given ? state.roll : warm_ ? roll_ : start_roll_ + tilt(state_);
  reason_ = {};
  own_grids_required_ = false;
  heights_ = z_;
  if (warm_ && !given)
  {
    predict(before);
  }
  for (const Side side : sides)
  {
    setLevel(side, 0);
    wheels_[side].setRail(state.rail_lateral_force[side], state_.rail_displacement[side]);
  }
  beginTransfer();
  WheelStatus status = WheelStatus::solved;
  do
  {
    status = given ? solveAtGivenHeight() : balanceLoads();
  } while (isUsable(status) && (requireOwnGrids() || refine()));
  const ContactStatus failed = isUsable(status) ? ContactStatus::ok : fail(status);
  depth_ = given ? depthOfHeight(status) : 0;
  if (depth_ > deepest_height)
  {
    reset();
    return ContactStatus::too_deep;
  }
  if (failed != ContactStatus::ok)
  {
    reset();
    return failed;
  }
  if (wheels_.left.contact().reachesEnd() || wheels_.right.contact().reachesEnd())
  {
    reset();
    reason_ = "contact lies beyond the end of a profile";
    return ContactStatus::off_profile;
  }
  warm_ = true;
  return wheels_.left.loaded() && wheels_.right.loaded() ? ContactStatus::ok : ContactStatus::lift_off;
}

/// Moves both rails to the place of the state on the line. Adds the displacement by the line to that of the state.
void WheelsetBalance::placeOnLine()
{
  for (const Side side : sides)
  {
    wheels_[side].moveTo(state_.distance);
  }
  if (const TrackLine* line = config_.track.line.get())
  {
    const Sides<RailDeflection> displaced =
        displacementsAt(line->at(state_.distance),
                        {wheels_.left.restingRail().referencePoint(), wheels_.right.restingRail().referencePoint()});
    state_.rail_displacement.left += displaced.left;
    state_.rail_displacement.right += displaced.right;
  }
}

/// Predicts heights and roll from the last contacts, after the movements of wheelset and rails since the state
/// `before`.
void WheelsetBalance::predict(const WheelsetState& before)
{
  for (const Side side : sides)
  {
    const RailDeflection &rail = state_.rail_displacement[side], &rail_before = before.rail_displacement[side];
    const double outward = sideSign(side) * (state_.y - before.y) - (rail.lateral - rail_before.lateral);
    heights_[side] += wheels_[side].heightPerLateral() * outward + rail.vertical - rail_before.vertical +
                      wheels_[side].heightPerRailRoll() * (rail.roll - rail_before.roll);
    wheels_[side].predict(outward, 0);
  }
  updateSlopes();
  turn(roll_ + tilt(state_) - tilt(before));
  const double step = -(heights_.left - heights_.right) / updateSlopes();
  turn(roll_ + std::clamp(step, -greatest_turn_, greatest_turn_));
}

/// Estimates the errors of a wheel. Returns the error that the tolerance limits.
double WheelsetBalance::estimate(Side side)
{
  const WheelContact& contact = wheels_[side].contact();
  islands_[side].find(contact.problem(), contact.solution());
  const NormalSolution& solution = islands_[side].solution();
  levels_.solver().estimateErrors(islands_[side].problem(), solution, errors_[side]);
  const auto measures_of = [](const PatchPressure& patch) {
    return ContactMeasures{patch.max_pressure, patch.area, patch.force};
  };
  ContactMeasures wheel;
  for (const PatchPressure& patch : solution.patches)
  {
    wheel.add(measures_of(patch));
  }
  WheelError error(wheel);
  for (std::size_t i = 0; i < solution.patches.size(); ++i)
  {
    error.add(measures_of(solution.patches[i]), errors_[side][i]);
  }
  return error.largest();
}

/// Estimates the errors. Chooses finer grids where they exceed the tolerance. @return true if there are any
bool WheelsetBalance::refine()
{
  bool refined = false;
  for (const Side side : sides)
  {
    if (unestimated_[side])
    {
      wheel_errors_[side] = wheels_[side].loaded() ? estimate(side) : 0;
      unestimated_[side] = false;
    }
    const std::size_t level = levels_.finer(level_[side], wheel_errors_[side]);
    if (level != level_[side])
    {
      wheels_[side].respond();
      setLevel(side, level);
      refined = true;
    }
  }
  return refined;
}

/// Has wheels solved again whose grids are not those of their final heights, so that the result does not depend on the
/// start of the search.
/// @return true if there are any; at most once on the same levels
bool WheelsetBalance::requireOwnGrids()
{
  if (own_grids_required_)
  {
    return false;
  }
  bool any = false;
  for (const Side side : sides)
  {
    const bool others = wheels_[side].loaded() && !wheels_[side].contact().hasOwnGrids();
    solved_[side] = solved_[side] && !others;
    any = any || others;
  }
  own_grids_required_ = true;
  return any;
}

void WheelsetBalance::setLevel(Side side, std::size_t level)
{
  level_[side] = level;
  wheels_[side].keepResponse(level > 0);
  own_grids_required_ = false;
  solved_[side] = false;
  wheels_[side].contact().setGrid(level, levels_.at(level));
}
}  // namespace wheel_rail_contact::core
