// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheelset_balance.h"

#include <algorithm>
#include <cmath>

#include "core/balance/tuning.h"
#include "core/constants.h"
#include "core/normal/estimate/islands.h"
#include "core/track/track_frame.h"
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

/// Solves a state along a path. It begins at the centre of the track: in long steps; or in short ones from the last
/// result on, on a finer grid and then on the first one. If these end without a result, it begins one long step further
/// out.
ContactStatus WheelsetBalance::solveAlongPath(const WheelsetState& state)
{
  const double centre = middleOf(placeOnLine(state).rail_displacement), way = state.y - centre;
  double reached = 0;
  ContactStatus status = walk(state, way, 0, 1, reached);
  for (std::size_t level = std::min<std::size_t>(2, levels_.count());
       status == ContactStatus::not_converged && level-- > 0;)
  {
    status = walk(state, way, level, tuning::shortest_share, reached);
  }
  reached = 0;
  return status != ContactStatus::not_converged
             ? status
             : walk(state, std::copysign(tuning::longest_step, -way), 0, tuning::shortest_share, reached);
}

/// Solves states on a way to a state, each from the result of the one before if it has one.
/// @param way      lateral [m], to the state
/// @param share    of the longest step from one state to the next beyond `reached`; up to there it is the longest
/// @param reached  set to the way up to the last result [m]
ContactStatus WheelsetBalance::walk(const WheelsetState& state, double way, std::size_t first_level, double share,
                                    double& reached)
{
  for (double gone = 0; gone < std::abs(way);
       gone += (gone < reached - 0.5 * tuning::longest_step ? 1 : share) * tuning::longest_step)
  {
    WheelsetState there = state;
    there.y = state.y - way + std::copysign(gone, way);
    const ContactStatus status = solveOnce(there, first_level);
    reached = status == ContactStatus::not_converged ? reached : std::max(reached, gone);
  }
  return solveOnce(state, first_level);
}

/// Solves from the last result. After a failure, the next call starts cold.
ContactStatus WheelsetBalance::solveOnce(const WheelsetState& state, std::size_t first_level)
{
  const bool given = !config_.wheelset.solve_height_and_roll;
  reason_ = {};
  search_.begin(placeOnLine(state), false);
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
  return statusOf(status);
}

ContactStatus WheelsetBalance::solveOnSameGrids(const WheelsetState& state)
{
  const bool given = !config_.wheelset.solve_height_and_roll;
  reason_ = {};
  search_.begin(placeOnLine(state), true);
  const WheelStatus status = given ? search_.solveAtGivenHeight() : search_.solve(WheelsetSearch::Start::near);
  for (const Side side : sides)
  {
    if (isUsable(status))
    {
      measure(side);
    }
  }
  return statusOf(status);
}

/// Status of a result at the end of its search.
ContactStatus WheelsetBalance::statusOf(WheelStatus status)
{
  const bool given = !config_.wheelset.solve_height_and_roll;
  const ContactStatus failed = isUsable(status) ? ContactStatus::ok : fail(status);
  depth_ = given ? depthOfHeight(status) : 0;
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

/// Depth of the given height below that of first touch, of the wheel that is less deep [m]. A wrong lateral position
/// lets only one wheel overlap its rail. After a failure, the positions of first touch replace the last solutions.
double WheelsetBalance::depthOfHeight(WheelStatus status)
{
  double depth = infinity;
  for (const Side side : sides)
  {
    WheelEquilibrium& wheel = this->wheel(side);
    const WheelsetState& state = search_.state();
    const WheelsetPose above{state.y, config_.wheelset.meanRadius(), state.yaw, state.roll};
    if (isUsable(status))
    {
      depth = std::min(depth, wheel.loaded() ? wheel.contact().overlap() : 0);
    }
    else
    {
      const bool touches = isUsable(wheel.solveUnderLoad(toSide(side, above), 0));
      depth = std::min(depth, touches ? wheel.height() - state.z : 0);
    }
  }
  return depth;
}

/// The result is not a start for the next call.
ContactStatus WheelsetBalance::discard(ContactStatus status, std::string_view reason)
{
  reset();
  reason_ = reason;
  return status;
}

/// Moves both rails to the place of the state on the line, and turns wheels that are not round. Adds the displacement
/// by the line to that of the state.
WheelsetState WheelsetBalance::placeOnLine(WheelsetState state)
{
  for (const Side side : sides)
  {
    wheel(side).moveTo(state.distance);
    if (const OutOfRound* shape = config_.wheelset.out_of_round[side].get())
    {
      wheel(side).setRim(rimAt(*shape, config_.wheelset.rolling_radius[side], state.pitch));
    }
  }
  if (const TrackLine* line = config_.track.line.get())
  {
    const Sides<PlanePoint> heads([this](Side side) { return wheel(side).restingRail().referencePoint(); });
    const Sides<RailDeflection> displaced = displacementsAt(line->at(state.distance), heads);
    Sides<RailCourse> courses = coursesAt(*line, state.distance, heads, config_.wheelset.rolling_radius);
    addTurn(*line, state.distance, heads, courses);
    for (const Side side : sides)
    {
      state.rail_displacement[side] += displaced[side];
      wheel(side).setCourse(courses[side]);
    }
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

/// Estimates the errors of a wheel that was solved since the last call.
void WheelsetBalance::measure(Side side)
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
}

/// Estimates the errors. Chooses finer grids where they exceed the tolerance. @return true if there are any
bool WheelsetBalance::refine()
{
  bool refined = false;
  for (const Side side : sides)
  {
    measure(side);
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
