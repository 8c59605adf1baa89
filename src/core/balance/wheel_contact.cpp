// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheel_contact.h"

#include <algorithm>
#include <cmath>

#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double touch_accuracy = 1e-8;  ///< of the height of first touch on a steep surface [m]
}  // namespace

WheelContact::WheelContact(const ContactModelConfig& config, Side side, const PlacedRail& rail, NormalSolver& solver,
                           double longest_rail)
    : solver_(solver),
      radius_(config.wheelset.rolling_radius[side]),
      grids_(config, side, rail, longest_rail),
      tangent_(tuning::last_step),
      first_reach_(usesOverlap(config.contact.method) ? OverlapGrids::Reach::whole : OverlapGrids::Reach::expected)
{
  solution_.status = SolveStatus::no_contact;
  problem_.modulus = contactModulus(config.wheel_material[side], config.rail_material[side]);
}

/// Removes the last solution.
WheelStatus WheelContact::none(WheelStatus status)
{
  solution_.patches.clear();
  solution_.approach = 0;
  solution_.status = SolveStatus::no_contact;
  solved_.clear();
  return status;
}

void WheelContact::setGrid(std::size_t level, const GridSize& size)
{
  grids_.unfollow();
  useGrid(level, size, first_reach_);
}

void WheelContact::refineTo(std::size_t level, const GridSize& size)
{
  grids_.follow(solution_.patches);
  useGrid(level, size, grids_.wouldBeComplete(size, problem_, solution_) ? first_reach_ : OverlapGrids::Reach::whole);
}

void WheelContact::useGrid(std::size_t level, const GridSize& size, OverlapGrids::Reach reach)
{
  size_ = size;
  reach_ = start_reach_ = reach;
  needs_whole_ = false;
  if (level != level_)
  {
    kept_.resize(std::max(kept_.size(), std::max(level, level_) + 1));
    std::swap(kept_[level_], solution_);
    std::swap(kept_[level], solution_);
    level_ = level;
    solution_.status = SolveStatus::no_contact;
    solved_.clear();
  }
}

void WheelContact::forget()
{
  none(WheelStatus::no_contact);
  grids_.unfollow();
  for (NormalSolution& solution : kept_)
  {
    solution.patches.clear();
  }
}

WheelStatus WheelContact::touch(const WheelsetPose& pose)
{
  pose_ = pose;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    if (build(first_reach_, OverlapGrids::Choice::own) == OverlapGrids::Overlap::beside)
    {
      return none(WheelStatus::beside_rail);
    }
    const double separation = grids_.touch().separation;
    pose_.z -= separation;
    // The separation falls with the height as it does itself, unless the flange back touches a check rail.
    if (std::abs(separation) < touch_accuracy || !RailSearch::isSteep(grids_.touch()))
    {
      break;
    }
  }
  return none(WheelStatus::no_contact);
}

WheelStatus WheelContact::solveAt(const WheelsetPose& pose, OverlapGrids::Choice choice)
{
  pose_ = pose;
  const OverlapGrids::Overlap overlap = build(reach_, choice);
  return overlap == OverlapGrids::Overlap::beside ? none(WheelStatus::beside_rail)
         : overlap == OverlapGrids::Overlap::none ? none(WheelStatus::no_contact)
                                                  : solve(NormalProblem::Control::approach, 0, choice);
}

double WheelContact::typicalOverlap(double load) const
{
  return std::cbrt(9.0 / 16 * load * load / (problem_.modulus * problem_.modulus * radius_));
}

WheelStatus WheelContact::solveLoad(const WheelsetPose& pose, double load, OverlapGrids::Choice choice)
{
  pose_ = pose;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    switch (build(reach_, choice))
    {
      case OverlapGrids::Overlap::beside:
        return none(WheelStatus::beside_rail);
      case OverlapGrids::Overlap::none:
        pose_.z -= grids_.touch().separation + typicalOverlap(load);
        break;
      default:
        return solve(NormalProblem::Control::load, load, choice);
    }
  }
  return none(WheelStatus::unbalanced);
}

OverlapGrids::Overlap WheelContact::build(OverlapGrids::Reach reach, OverlapGrids::Choice choice)
{
  return grids_.build(pose_, size_, choice, reach, problem_);
}

/// Solves the problem, from the last solution if that is possible.
void WheelContact::solveProblem()
{
  const bool warm = solution_.patches.size() == problem_.patches.size();
  solver_.solveCurved(problem_, warm, solution_);
  if (warm && !isUsable(solution_.status))
  {
    solver_.solveCurved(problem_, false, solution_);
  }
  ++solutions_;
}

WheelStatus WheelContact::solve(NormalProblem::Control control, double value, OverlapGrids::Choice choice)
{
  problem_.control = control;
  problem_.value = value;
  solveProblem();
  const bool is_complete = !isUsable(solution_.status) || grids_.isComplete(problem_, solution_);
  needs_whole_ = !is_complete || (needs_whole_ && grids_.follows());
  if (!is_complete)
  {
    if (build(OverlapGrids::Reach::whole, choice) != OverlapGrids::Overlap::found)
    {
      return none(WheelStatus::unbalanced);  // the overlap is between the columns of the larger grid
    }
    solveProblem();
    reach_ = isDeepEnough() ? OverlapGrids::Reach::whole : reach_;
  }
  if (!isUsable(solution_.status))
  {
    const SolveStatus status = solution_.status;
    none(WheelStatus::normal_failed);
    solution_.status = status;
    return WheelStatus::normal_failed;
  }
  solved_.set(grids_.columns(), problem_, solution_, {pose_.y, pose_.z, 0, 0}, rail().referencePoint());
  if (solution_.status == SolveStatus::no_contact)
  {
    return none(WheelStatus::no_contact);
  }
  return WheelStatus::solved;
}

bool WheelContact::hasOwnGrids()
{
  const bool has_own = needs_whole_ || reach_ == start_reach_ || !grids_.wouldBeComplete(size_, problem_, solution_);
  reach_ = has_own ? reach_ : start_reach_;
  return has_own && grids_.fits(remaining());
}

bool WheelContact::reachesEnd() const
{
  return solved_.isLoadedAtEnd(grids_.wheelLength()) || grids_.missesOverlap();
}

MotionMatrix WheelContact::stiffness(double residual)
{
  tangent_.setResidual(residual);
  return solved_.isLoaded() ? solved_.stiffness(tangent_.stiffness(problem_, solution_, solved_.openings()))
                            : MotionMatrix::Zero();
}

MotionVector WheelContact::verticalStiffness()
{
  tangent_.setResidual(tuning::last_step);
  return solved_.isLoaded() ? solved_.verticalStiffness(tangent_.stiffness(problem_, solution_, solved_.openings(), 0))
                            : MotionVector::Zero();
}
}  // namespace wheel_rail_contact::core
