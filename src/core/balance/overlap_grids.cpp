// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/overlap_grids.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/balance/grid_layout.h"
#include "core/balance/tuning.h"
#include "core/constants.h"
#include "core/normal/estimate/error_estimate.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_overlap = 1e-9;  ///< smaller ones are below the accuracy of the search [m]
constexpr std::size_t usual_grids = 4;  ///< of a wheel, for which memory is reserved

/// Adds a part of its length and width to each side of an area.
void grow(double along, double across, SurfaceArea& area)
{
  const double length = area.x_most - area.x_least, width = area.arc_most - area.arc_least;
  area.x_least -= along * length;
  area.x_most += along * length;
  area.arc_least -= across * width;
  area.arc_most += across * width;
}

/// True if the overlap reaches an end of its grid along the track.
bool isCutAlong(const PatchGap& patch)
{
  const auto last = patch.gap.rows() - 1;
  return patch.gap.row(last).minCoeff() < 0 || (!patch.grid.symmetric && patch.gap.row(0).minCoeff() < 0);
}

/// True if the overlap reaches a side of its grid across the track.
bool isCutAcross(const PatchGap& patch)
{
  return patch.gap.col(0).minCoeff() < 0 || patch.gap.col(patch.gap.cols() - 1).minCoeff() < 0;
}

/// True if an overlap is so deep, along the normal, that cells find it, unless a profile ends there.
bool isDeep(const OverlapInterval& interval)
{
  constexpr double depth = 20e-6;  // [m]
  const InitialContact& contact = interval.contact;
  return -contact.separation > depth * std::hypot(1, contact.slope);
}
}  // namespace

OverlapGrids::OverlapGrids(const ContactModelConfig& config, Side side, const PlacedRail& rail, double longest_rail)
    : config_(config),
      side_(side),
      search_(*config.wheel_profile[side], rail.profile(), longest_rail,
              config.rail_sections[side] && config.rail_sections[side]->parts().size() > 1),
      outside_(search_, placed_, columns_)
{
  group_grids_.reserve(usual_grids);
  earlier_grids_.reserve(usual_grids);
  placed_.reserve(usual_grids);
  pressed_.reserve(usual_grids);
  joined_.reserve(2 * usual_grids);
}

void OverlapGrids::setRail(const PlacedRail& rail, bool reshaped)
{
  rail_ = rail;
  search_.setRail(rail, reshaped);
}

PlacedWheel OverlapGrids::wheelAt(double z) const
{
  WheelsetPose pose = placed_wheel_->pose();
  pose.z = z;
  return {*config_.wheel_profile[side_], config_.wheelset, side_, pose, rail_->rim().rise};
}

OverlapGrids::Overlap OverlapGrids::build(const WheelsetPose& pose, const GridSize& size, Choice choice, Reach reach,
                                          CurvedProblem& problem)
{
  placed_wheel_.emplace(*config_.wheel_profile[side_], config_.wheelset, side_, pose, rail_->rim().rise);
  search_.setWheel(*placed_wheel_);
  if (!search_.nearest(touch_))
  {
    return Overlap::beside;
  }
  if (!(touch_.separation < -least_overlap))
  {
    return Overlap::none;
  }
  search_.overlapIntervals(0, intervals_);
  std::swap(earlier_grids_, group_grids_);
  join(choice != Choice::own);
  group_grids_.clear();
  placed_.clear();
  misses_overlap_ = false;
  for (std::size_t first = 0, end = 0; first < intervals_.size(); first = end)
  {
    end = endOfGroup(intervals_, first);
    addGrid(first, end, size, choice, reach, problem);
  }
  resize(placed_.size(), problem);
  couple(placed_, columns_, problem);
  return problem.patches.empty() ? Overlap::beside : Overlap::found;
}

/// Sets the parts of the rail profile of which each is in one grid: those that carry pressure, and those of the last
/// grids if these are kept.
void OverlapGrids::join(bool keep)
{
  joined_.clear();
  for (const RailRegion& one : pressed_)
  {
    joined_.emplace_back(one.u_begin, one.u_end);
  }
  for (std::size_t k = 0; keep && k < earlier_grids_.size(); ++k)
  {
    const auto& [grid, origin] = earlier_grids_[k].used;
    joined_.emplace_back(origin.rail_u + grid.y(0), origin.rail_u + grid.y(grid.ny - 1));
  }
}

/// End (exclusive) of the intervals from `first` on that are in one grid: each is closer to the next than the wider of
/// them is wide, or a little more if both are in one of the joined parts. Farther ones would make the cells too wide.
std::size_t OverlapGrids::endOfGroup(const std::vector<OverlapInterval>& intervals, std::size_t first) const
{
  const auto width = [&](std::size_t k) { return intervals[k].u_end - intervals[k].u_begin; };
  double widest = width(first);
  std::size_t end = first + 1;
  while (end < intervals.size())
  {
    const double u_begin = intervals[end - 1].u_end, u_end = intervals[end].u_begin;
    const bool are_joined = std::any_of(joined_.begin(), joined_.end(),
                                        [&](const auto& one) { return one.first < u_begin && one.second > u_end; });
    if (u_end - u_begin >= std::max(widest, width(end)) * (are_joined ? tuning::most_larger : 1))
    {
      break;
    }
    widest = std::max(widest, width(end++));
  }
  return end;
}

bool OverlapGrids::fits(double lower)
{
  search_.overlapIntervals(lower, lower_intervals_);
  join(false);
  std::size_t count = 0;
  for (std::size_t first = 0, end = 0; first < lower_intervals_.size(); first = end, ++count)
  {
    if (count >= group_grids_.size())
    {
      return false;
    }
    end = endOfGroup(lower_intervals_, first);
    const GroupGrid& group = group_grids_[count];
    const Grid& grid = group.planned.grid;
    const SurfaceArea area = areaOf(&lower_intervals_[first], &lower_intervals_[0] + end, lower, group.reach);
    if (group.has_patch && !layGrid(area, {grid.nx, grid.ny}, grid.symmetric).equals(group.planned))
    {
      return false;
    }
  }
  return count == group_grids_.size();
}

/// The area for the intervals from `begin` to `end` (exclusive) of the wheel `lower` below its place [m]. Its origin is
/// the deepest place.
SurfaceArea OverlapGrids::areaOf(const OverlapInterval* begin, const OverlapInterval* end, double lower,
                                 Reach reach) const
{
  const PlacedWheel& wheel = *placed_wheel_;
  const InitialContact& deepest = std::min_element(begin, end,
                                                   [](const OverlapInterval& one, const OverlapInterval& other)
                                                   { return one.contact.separation < other.contact.separation; })
                                      ->contact;
  RailRegion part = overlapOf(wheel, *rail_, begin, end, lower), inner;
  const bool whole =
      reach == Reach::whole || !(findPressed(begin->u_begin, (end - 1)->u_end, inner) ||
                                 (end - begin == 1 && findContact(search_, wheel, *rail_, *begin, lower, inner)));
  if (!whole)
  {
    part = {std::max(part.x_least, inner.x_least), std::min(part.x_most, inner.x_most),
            std::max(part.u_begin, inner.u_begin), std::min(part.u_end, inner.u_end)};
  }
  const Profile& profile = rail_->profile();
  return {part.x_least,
          part.x_most,
          arcLength(profile, deepest.rail_u, part.u_begin),
          arcLength(profile, deepest.rail_u, part.u_end),
          {0, deepest.rail_u, deepest.wheel_u},
          0.5 * (part.x_most - part.x_least) / (whole ? std::sqrt(2) : tuning::contact_margin),
          whole};
}

void OverlapGrids::follow(const std::vector<PatchPressure>& pressure)
{
  pressed_.clear();
  for (std::size_t k = 0; k < pressure.size(); ++k)
  {
    pressed_.push_back(loadedPart(pressure[k], originOf(k), columns_[k], 1.5));  // half of the outer cell, and one more
  }
}

/// Finds the part that carries pressure between two parameters of the rail profile. @return false if there is none
bool OverlapGrids::findPressed(double u_begin, double u_end, RailRegion& all) const
{
  all = {infinity, -infinity, infinity, -infinity};
  for (const RailRegion& one : pressed_)
  {
    if (one.u_end > u_begin && one.u_begin < u_end)
    {
      all = {std::min(all.x_least, one.x_least), std::max(all.x_most, one.x_most), std::min(all.u_begin, one.u_begin),
             std::max(all.u_end, one.u_end)};
    }
  }
  return all.x_most > all.x_least;
}

bool OverlapGrids::isComplete(const NormalProblem& problem, const NormalSolution& solution)
{
  return outside_.isContained(placed_, intervals_, problem, solution);
}

bool OverlapGrids::wouldBeComplete(const GridSize& size, const NormalProblem& problem, const NormalSolution& solution)
{
  planned_.clear();
  for (const GroupGrid& group : group_grids_)
  {
    if (group.has_patch)
    {
      const SurfaceArea area = areaOf(&intervals_[group.first], &intervals_[0] + group.end, 0, Reach::expected);
      planned_.push_back({layGrid(area, size, isSymmetric()), area.half_length, area.whole});
    }
  }
  return outside_.isContained(planned_, intervals_, problem, solution);
}

/// A grid of the last call that covers the area; null if there is none.
const OverlapGrids::GroupGrid* OverlapGrids::earlierGrid(const SurfaceArea& area, const GridSize& size) const
{
  for (const GroupGrid& group : earlier_grids_)
  {
    const double shift = arcLength(rail_->profile(), group.used.origin.rail_u, area.origin.rail_u);
    if (GridSize{group.used.grid.nx, group.used.grid.ny} == size && group.used.grid.symmetric == isSymmetric() &&
        covers(group.used, area, shift, tuning::most_larger))
    {
      return &group;
    }
  }
  return nullptr;
}

/// Adds the grid over the intervals `first` to `last` (exclusive), if there are columns that overlap.
void OverlapGrids::addGrid(std::size_t first, std::size_t last, const GridSize& size, Choice choice, Reach reach,
                           CurvedProblem& problem)
{
  const OverlapInterval *const begin = &intervals_[first], *const end = begin + (last - first);
  const SurfaceArea area = areaOf(begin, end, 0, reach);
  const GroupGrid* const before = choice != Choice::own ? earlierGrid(area, size) : nullptr;
  const GridLayout planned = layGrid(area, size, isSymmetric());
  GroupGrid group = before != nullptr ? *before : GroupGrid{planned, planned, reach};
  group.reach = reach;
  const std::size_t k = placed_.size();
  resize(std::max(k + 1, columns_.size()), problem);
  const auto fill = [&]
  { return fillGrid(size, area, group.used, columns_[k], problem.patches[k], problem.normals[k]); };
  bool found = fill();
  if (!found && before != nullptr)  // the cells of the kept grid are too large
  {
    group = {planned, planned, reach};
    found = fill();
  }
  group.has_patch = found;
  group.first = first;
  group.end = last;
  group_grids_.push_back(group);
  if (!found)
  {
    misses_overlap_ = misses_overlap_ || std::any_of(begin, end, isDeep);
    return;
  }
  placed_.push_back({group.used, area.half_length, area.whole});
}

/// Fills columns and patch. If the area is the whole overlap, and the overlap is found to be larger, area and grid are
/// widened. @return false if no cell overlaps
bool OverlapGrids::fillGrid(const GridSize& size, SurfaceArea area, GridLayout& layout,
                            std::vector<SurfaceColumn>& columns, PatchGap& patch, ColumnNormals& normals)
{
  for (double margin = tuning::overlap_margin; margin < 2; margin *= 2)
  {
    patch.grid = layout.grid;
    if (!buildSurfaceGap(*placed_wheel_, *rail_, layout.origin, layout.grid, patch.gap, slope_, columns))
    {
      return false;
    }
    leaveOutWalls(columns, patch);
    const bool long_enough = !area.whole || !isCutAlong(patch), wide_enough = !area.whole || !isCutAcross(patch);
    if (long_enough && wide_enough)
    {
      if (!(patch.gap.minCoeff() < 0))
      {
        return false;
      }
      setNormals(columns, patch, normals);
      fillUnseenSlope(patch, [&](Eigen::Index j) { return gapSlope(columns, patch, j); });
      if (!usesOverlap(config_.contact.method))
      {
        raiseByCells(patch);
      }
      return true;
    }
    grow(long_enough ? 0 : margin, wide_enough ? 0 : margin, area);
    layout = layGrid(area, size, isSymmetric());
  }
  return false;
}

/// Sets the number of patches. Those that remain keep their memory.
void OverlapGrids::resize(std::size_t count, CurvedProblem& problem)
{
  columns_.resize(count);
  problem.patches.resize(count);
  problem.normals.resize(count);
}
}  // namespace wheel_rail_contact::core
