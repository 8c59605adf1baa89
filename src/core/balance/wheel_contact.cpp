// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheel_contact.h"

#include <algorithm>
#include <cmath>

#include "core/balance/missed_pressure.h"
#include "core/balance/penetration_step.h"
#include "core/normal/estimate/unseen_slope.h"
#include "core/normal/solvers/hertz.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr int most_boxes = 10;                   ///< limit of the grids in one call
constexpr int estimate_steps = 4;                ///< fixed-point steps of estimatePenetration()
constexpr double penetration_error_limit = 0.1;  ///< largest penetrationError() of an accepted solution [-]
constexpr double far_slip = 1e-4;  ///< displacement of the rail along the planes above which the rail is set again
                                   ///< before the boxes are checked further [m]
constexpr double penetration_allowance = 1.02;  ///< see boxesHold() [-]

/// Removes the bodies beyond the interval of the patch. The pressure there belongs to the neighbouring patches.
void clearBeyond(const WheelPatch& patch, Eigen::ArrayXXd& gap)
{
  for (std::size_t j = 0; j < patch.columns.size(); ++j)
  {
    const double u = patch.columns[j].rail_u;
    if (u < patch.interval.u_least || u > patch.interval.u_most)
    {
      gap.col(static_cast<Eigen::Index>(j)).setConstant(no_body_gap);
    }
  }
}

bool differInHeightOnly(const WheelsetPose& one, const WheelsetPose& other)
{
  return one.y == other.y && one.yaw == other.yaw && one.roll == other.roll;
}

double wheelRadius(const ContactModelConfig& config, const InitialContact& contact)
{
  return config.wheelset.rolling_radius - config.wheel_profile->at(contact.wheel_u).z;
}
}  // namespace

WheelContact::WheelContact(const ContactModelConfig& config, NormalSolver& solver)
    : config_(config),
      solver_(&solver),
      modulus_(contactModulus(config.wheel_material, config.rail_material)),
      search_(*config.wheel_profile, *config.rail_profile)
{
}

void WheelContact::begin(double moved)
{
  trend_.begin(moved);
  expected_ = trend_.penetration();
  for (PatchMemory& memory : memory_)
  {
    memory.turned = 0;
  }
  if (memory_.size() == 1)
  {
    memory_.front().turn += trend_.turn();
  }
}

void WheelContact::finish()
{
  learn();
  if (memory_.size() == 1 && load_ > 0)
  {
    trend_.finish(solution_.approach / std::cbrt(load_ * load_), memory_.front().turn);
  }
  else
  {
    trend_.reset();
  }
}

void WheelContact::reset()
{
  memory_.clear();
  patches_.clear();
  solution_ = NormalSolution();
  errors_.clear();
  forces_ = WheelForces();
  load_ = 0;
  trend_.reset();
  expected_ = 1;
}

RigidTouch WheelContact::touch(const WheelsetPose& pose)
{
  const WheelsetPose grounded{pose.y, 0, pose.yaw, pose.roll};
  held_ = differInHeightOnly(grounded, learned_);
  if (touch_ && differInHeightOnly(grounded, wheel_->pose()))
  {
    return *touch_;
  }
  wheel_.emplace(*config_.wheel_profile, config_.wheelset, grounded);
  search_.setWheel(*wheel_);
  RigidTouch& touch = touch_.emplace();
  touch.found = search_.nearest(touch.contact);
  if (touch.found)
  {
    touch.axle_height = -touch.contact.separation;
    const PlanePoint point = rail_->at(touch.contact.rail_u);
    touch.lever = point.y - pose.y + (point.z - touch.axle_height) * touch.contact.slope;
  }
  return touch;
}

double WheelContact::estimatePenetration(const RigidTouch& touch, double load) const
{
  if (load_ > 0)
  {
    return expected_ * solution_.approach * std::cbrt((load / load_) * (load / load_));
  }
  const double cosine = 1 / std::hypot(1, touch.contact.slope);
  const double along = 0.5 * cosine / wheelRadius(config_, touch.contact);
  double penetration = 1e-4;
  for (int i = 0; i < estimate_steps; ++i)
  {
    const OverlapInterval interval = search_.intervalAround(touch.contact, touch.contact.separation + penetration);
    const double half = 0.5 * (interval.u_end - interval.u_begin);
    const double across = penetration * cosine / (half * half);
    penetration = hertzForForce({along, across}, modulus_, load / cosine).approach / cosine;
  }
  return penetration;
}

WheelStatus WheelContact::solveLoad(const RigidTouch& touch, double load, const GridSize& size)
{
  problem_.control = NormalProblem::Control::load;
  problem_.value = load;
  solution_.approach = estimatePenetration(touch, load);
  expected_ = 1;
  const WheelStatus status = solve(touch, size);
  load_ = status == WheelStatus::solved ? load : 0;
  return status;
}

WheelStatus WheelContact::solvePenetration(const RigidTouch& touch, double penetration, const GridSize& size)
{
  if (!(penetration > 0))
  {
    reset();
    return WheelStatus::no_contact;
  }
  problem_.control = NormalProblem::Control::approach;
  problem_.value = penetration;
  solution_.approach = penetration;
  const WheelStatus status = solve(touch, size);
  load_ = status == WheelStatus::solved ? forces_.vertical : 0;
  return status;
}

WheelStatus WheelContact::solve(const RigidTouch& touch, const GridSize& size)
{
  problem_.modulus = modulus_;
  PenetrationStep step;
  for (int attempt = 0; attempt < most_boxes; ++attempt)
  {
    if (!layBoxes(touch, size))
    {
      return WheelStatus::off_profile;
    }
    solver_->solve(problem_, true, solution_);
    if (const SolveStatus status = solution_.status; !isUsable(status))
    {
      solver_->solve(problem_, false, solution_);
    }
    ++solutions_;
    if (const SolveStatus status = solution_.status; !isUsable(status))
    {
      reset();
      solution_.status = status;
      return WheelStatus::normal_failed;
    }
    measure();
    if (solution_.status == SolveStatus::no_contact)
    {
      reset();
      return WheelStatus::no_contact;
    }
    settleSupport();
    widened_ = widened_ && attempt > 0;
    const bool hold = boxesHold(touch);
    if (hold && std::abs(penetrationError()) < penetration_error_limit)
    {
      const bool on_profiles = std::all_of(patches_.begin(), patches_.end(),
                                           [this](const WheelPatch& patch)
                                           { return onProfiles(patch, *config_.wheel_profile, rail_->profile()); });
      return on_profiles ? WheelStatus::solved : WheelStatus::off_profile;
    }
    if (!hold)
    {
      learn();
    }
    solution_.approach = step.next(boxed_penetration_, solution_.approach);
    if (railSlip() > far_slip)
    {
      return WheelStatus::solved;
    }
  }
  const WheelStatus status = spike_ ? WheelStatus::spike : WheelStatus::box_not_found;
  reset();
  return status;
}

/// Memory of the contact in this interval; an initial guess if there is none.
PatchMemory& WheelContact::recall(const OverlapInterval& interval)
{
  PatchMemory* nearest = nullptr;
  for (PatchMemory& memory : memory_)
  {
    const bool inside = memory.rail_u >= interval.u_begin && memory.rail_u <= interval.u_end;
    if (inside && (nearest == nullptr || std::abs(memory.rail_u - interval.contact.rail_u) <
                                             std::abs(nearest->rail_u - interval.contact.rail_u)))
    {
      nearest = &memory;
    }
  }
  if (nearest == nullptr)
  {
    memory_.push_back(firstGuess(interval));
    nearest = &memory_.back();
  }
  return *nearest;
}

bool WheelContact::layBoxes(const RigidTouch& touch, const GridSize& size)
{
  problem_.support = support_;
  boxed_penetration_ = solution_.approach;
  touch_separation_ = touch.contact.separation;
  wheel_->setHeight(touch.axle_height - boxed_penetration_);
  search_.overlapIntervals(touch.contact.separation + boxed_penetration_, intervals_);
  problem_.patches.resize(intervals_.size());
  patches_.resize(intervals_.size());
  for (std::size_t k = 0; k < intervals_.size(); ++k)
  {
    WheelPatch& patch = patches_[k];
    PatchGap& gap = problem_.patches[k];
    patch.interval = intervals_[k];
    patch.touch_gap = patch.interval.contact.separation - touch.contact.separation;
    patch.half_overlap =
        std::sqrt(2 * (boxed_penetration_ - patch.touch_gap) * wheelRadius(config_, patch.interval.contact));
    layPatch(*wheel_, *rail_, size, held_, recall(patch.interval), patch, gap.grid);
    gap.weight = std::cos(patch.plane.angle);
    const bool sound = gap.grid.dx > 0 && gap.grid.dy > 0;
    if (!sound || !buildGap(*wheel_, *rail_, patch.plane, gap.grid, gap.gap, patch.columns))
    {
      return false;
    }
    fillUnseenSlope(gap, [&patch](Eigen::Index j) { return patch.columns[static_cast<std::size_t>(j)].gap_slope; });
    gap.gap += gap.weight * boxed_penetration_;
    clearBeyond(patch, gap.gap);
    patch.least_gap = leastGap(gap.grid, gap.gap);
    fillOpening(*rail_, patch.plane, gap.grid, patch.columns, gap.opening);
  }
  return !intervals_.empty();
}

void WheelContact::measure()
{
  box_fill_ = 1;
  box_cut_ = false;
  spike_ = false;
  forces_ = sumOfForces();
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const Grid& grid = problem_.patches[k].grid;
    WheelPatch& patch = patches_[k];
    measurePatch(grid, solution_.patches[k].pressure, patch);
    const PressureExtent& extent = patch.extent;
    if (!extent.empty())
    {
      box_cut_ = box_cut_ || extent.cut(grid);
      spike_ = spike_ || extent.spike();
      box_fill_ = std::min({box_fill_, (extent.y_end - extent.y_begin) / patch.expected_width,
                            2 * extent.half_length / patch.expected_length});
    }
  }
}

void WheelContact::learn()
{
  memory_.clear();
  learned_ = wheel_->pose();
  held_ = true;
  const double grown = std::sqrt(
      std::clamp(solution_.approach / boxed_penetration_, 1 / PenetrationStep::longest, PenetrationStep::longest));
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    if (!patches_[k].extent.empty())
    {
      memory_.push_back(remember(*wheel_, *rail_, patches_[k], problem_.patches[k].grid, grown));
    }
  }
}

/// Finds the stations at which the bodies overlap in the interval of a patch at this separation [m]; without yaw, only
/// those beside the columns of the grid.
void WheelContact::findStations(std::size_t patch, double separation)
{
  const OverlapInterval& interval = patches_[patch].interval;
  const std::vector<GapColumn>& columns = patches_[patch].columns;
  stations_.clear();
  if (problem_.patches[patch].grid.symmetric)
  {
    // A grid laid from the memory may lie completely beside the interval.
    search_.addStationsBetween(interval.u_begin, std::min(columns.front().rail_u, interval.u_end), separation,
                               stations_);
    search_.addStationsBetween(std::max(columns.back().rail_u, interval.u_begin), interval.u_end, separation,
                               stations_);
  }
  else
  {
    search_.addStationsBetween(interval.u_begin, interval.u_end, separation, stations_);
  }
}

bool WheelContact::missesPressure(const RigidTouch& touch)
{
  bool missed = false;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    WheelPatch& patch = patches_[k];
    if (!patch.extent.empty())
    {
      findStations(k, touch.contact.separation + solution_.approach);
      const SolvedPatch solved{problem_.patches[k].grid, solution_.patches[k].pressure, modulus_, solution_.approach};
      missed = growOverMissedPressure(solved, *wheel_, stations_, patch) || missed;
    }
  }
  return missed;
}

/// True if the boxes contain all of the pressure. If the penetration exceeds its estimate by penetration_allowance,
/// also checks that no further overlap interval is in contact.
bool WheelContact::boxesHold(const RigidTouch& touch)
{
  const bool missed = missesPressure(touch);
  widened_ = widened_ || missed;
  if (box_cut_ || spike_ || missed)
  {
    return false;
  }
  if (solution_.approach < penetration_allowance * boxed_penetration_)
  {
    return true;
  }
  search_.overlapIntervals(touch.contact.separation + solution_.approach, intervals_);
  return std::all_of(intervals_.begin(), intervals_.end(),
                     [this](const OverlapInterval& interval)
                     {
                       return std::any_of(patches_.begin(), patches_.end(),
                                          [&](const WheelPatch& patch) {
                                            return interval.u_begin < patch.interval.u_end &&
                                                   patch.interval.u_begin < interval.u_end;
                                          });
                     });
}
}  // namespace wheel_rail_contact::core
