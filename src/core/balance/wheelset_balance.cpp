// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheelset_balance.h"

#include <algorithm>
#include <cmath>

#include "core/balance/tuning.h"
#include "core/normal/estimate/islands.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double deepest_height = 0.01;  ///< of a given height below that of first touch [m]
constexpr std::string_view no_balance = "no balance of height, roll and rail deflection was found";
}  // namespace

WheelsetBalance::WheelsetBalance(const ContactModelConfig& config, const GridLevels& levels)
    : config_(config), levels_(levels), search_(config, levels.solver())
{
}

void WheelsetBalance::reset(double roll)
{
  search_.reset(roll);
}

int WheelsetBalance::count() const
{
  return wheel(Side::left).contact().solutions() + wheel(Side::right).contact().solutions();
}

ContactStatus WheelsetBalance::fail(WheelStatus status)
{
  const SolveStatus left = wheel(Side::left).contact().solution().status;
  switch (status)
  {
    case WheelStatus::beside_rail:
      reason_ = "a wheel is beside its rail";
      return ContactStatus::off_profile;
    case WheelStatus::normal_failed:
      reason_ = toString(isUsable(left) ? wheel(Side::right).contact().solution().status : left);
      return ContactStatus::not_converged;
    default:
      reason_ = no_balance;
      return ContactStatus::not_converged;
  }
}

ContactStatus WheelsetBalance::solve(const WheelsetState& state)
{
  const int solved_before = count();
  const bool was_warm = search_.isWarm();
  ContactStatus status = solveOnce(state);
  if (status == ContactStatus::not_converged && was_warm)
  {
    status = solveOnce(state);
  }
  const NormalMethod method = config_.contact.method;
  const bool continuous = method == NormalMethod::automatic || method == NormalMethod::conjugate_gradient;
  if (continuous && config_.wheelset.solve_height_and_roll && reason_ == no_balance)
  {
    status = solveAlongPath(state);
  }
  solutions_ = count() - solved_before;
  return status;
}

/// Solves a state from the centre of the track: in long steps, or if that has no result, in short ones from the last
/// result on, on a finer grid and then on the first one.
ContactStatus WheelsetBalance::solveAlongPath(const WheelsetState& state)
{
  double reached = 0;
  ContactStatus status = walk(state, 0, 1, reached);
  for (std::size_t level = std::min<std::size_t>(2, levels_.count());
       status == ContactStatus::not_converged && level-- > 0;)
  {
    status = walk(state, level, tuning::shortest_share, reached);
  }
  return status;
}

/// Solves states on the way from the centre of the track, each from the result of the one before if it has one.
/// @param share    of the longest step from one state to the next beyond `reached`; up to there it is the longest
/// @param reached  set to the way up to the last result [m]
ContactStatus WheelsetBalance::walk(const WheelsetState& state, std::size_t first_level, double share, double& reached)
{
  const double centre = middleOf(placeOnLine(state).rail_displacement), whole = std::abs(state.y - centre);
  for (double way = 0; way < whole;
       way += (way < reached - 0.5 * tuning::longest_step ? 1 : share) * tuning::longest_step)
  {
    WheelsetState there = state;
    there.y = centre + std::copysign(way, state.y - centre);
    const ContactStatus status = solveOnce(there, first_level);
    reached = status == ContactStatus::not_converged ? reached : std::max(reached, way);
  }
  return solveOnce(state, first_level);
}

/// Solves from the last result. After a failure, the next call starts cold.
ContactStatus WheelsetBalance::solveOnce(const WheelsetState& state, std::size_t first_level)
{
  const bool given = !config_.wheelset.solve_height_and_roll;
  reason_ = {};
  search_.begin(placeOnLine(state));
  for (const Side side : sides)
  {
    level_[side] = first_level;
    wheel(side).contact().setGrid(first_level, levels_.at(first_level));
  }
  WheelStatus status = WheelStatus::solved;
  auto start = first_level > 0 ? WheelsetSearch::Start::near : WheelsetSearch::Start::other_state;
  do
  {
    status = given ? search_.solveAtGivenHeight() : search_.solve(start);
  } while (isUsable(status) && continues(start));
  const ContactStatus failed = isUsable(status) ? ContactStatus::ok : fail(status);
  depth_ = given ? search_.depthOfHeight(status) : 0;
  if (depth_ > deepest_height || failed != ContactStatus::ok)
  {
    return discard(depth_ > deepest_height ? ContactStatus::too_deep : failed, reason_);
  }
  const WheelEquilibrium &left = wheel(Side::left), &right = wheel(Side::right);
  if (left.contact().reachesEnd() || right.contact().reachesEnd())
  {
    return discard(ContactStatus::off_profile, "contact lies beyond the end of a profile");
  }
  return left.loaded() && right.loaded() ? ContactStatus::ok : ContactStatus::lift_off;
}

/// The result is not a start for the next call.
ContactStatus WheelsetBalance::discard(ContactStatus status, std::string_view reason)
{
  reset();
  reason_ = reason;
  return status;
}

/// Moves both rails to the place of the state on the line. Adds the displacement by the line to that of the state.
WheelsetState WheelsetBalance::placeOnLine(WheelsetState state)
{
  for (const Side side : sides)
  {
    wheel(side).moveTo(state.distance);
  }
  if (const TrackLine* line = config_.track.line.get())
  {
    const Sides<RailDeflection> displaced = displacementsAt(
        line->at(state.distance),
        {wheel(Side::left).restingRail().referencePoint(), wheel(Side::right).restingRail().referencePoint()});
    state.rail_displacement.left += displaced.left;
    state.rail_displacement.right += displaced.right;
  }
  return state;
}

/// Estimates the errors of a wheel. Returns the error that the tolerance limits.
double WheelsetBalance::estimate(Side side)
{
  const WheelContact& contact = wheel(side).contact();
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

/// Sets what the next search on other grids starts with. @return false if none is required
bool WheelsetBalance::continues(WheelsetSearch::Start& start)
{
  using Start = WheelsetSearch::Start;
  if (start != Start::other_grids && renewForeignGrids())
  {
    start = Start::other_grids;
    return true;
  }
  start = Start::near;
  return refine();
}

/// Estimates the errors. Chooses finer grids where they exceed the tolerance. @return true if there are any
bool WheelsetBalance::refine()
{
  bool refined = false;
  for (const Side side : sides)
  {
    const int solutions = wheel(side).contact().solutions();
    if (!wheel(side).loaded())
    {
      wheel_errors_[side] = 0;
    }
    else if (solutions != estimated_[side])
    {
      wheel_errors_[side] = estimate(side);
      estimated_[side] = solutions;
    }
    const std::size_t level = levels_.finer(level_[side], wheel_errors_[side]);
    if (level != level_[side])
    {
      wheel(side).respond();
      wheel(side).contact().refineTo(level, levels_.at(level));
      search_.renew(side);
      level_[side] = level;
      refined = true;
    }
  }
  return refined;
}

/// Has wheels solved again whose grids are not those of their final heights, so that the result does not depend on the
/// start of the search.
/// @return true if there are any
bool WheelsetBalance::renewForeignGrids()
{
  bool any = false;
  for (const Side side : sides)
  {
    if (wheel(side).loaded() && !wheel(side).contact().hasOwnGrids())
    {
      search_.renew(side);
      any = true;
    }
  }
  return any;
}
}  // namespace wheel_rail_contact::core
