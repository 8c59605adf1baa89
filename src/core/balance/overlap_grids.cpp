// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/overlap_grids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/normal/estimate/unseen_slope.h"
#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
const double pi = std::acos(-1.0);

constexpr double least_overlap = 1e-9;      ///< smaller ones are below the accuracy of the search [m]
constexpr double margin = 0.05;             ///< of an area beyond each end of the overlap, over its width [-]
constexpr double margin_along = 0.08;       ///< the same along the track, where the radius of the wheel varies [-]
constexpr double reserve = 0.1;             ///< of an area on each side, during a search [-]
constexpr double most_larger_kept = 1.8;    ///< length of a kept grid over that of the area [-]
constexpr double most_larger_reserved = 4;  ///< the same for Choice::reserved [-]
constexpr double widening = 0.15;           ///< of an area whose border the overlap reaches, on each side [-]
constexpr std::size_t usual_grids = 4;      ///< of a wheel, for which memory is reserved
constexpr int most_widenings = 8;           ///< of one grid
constexpr double smallest_opening = 0.05;   ///< columns that a vertical displacement opens by less are left out [-]
constexpr double plane_turn = 0.2;          ///< turn of the normals that is neglected [rad]

/// Range of the overlap along the track [m].
struct Extent
{
  double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
};

/// Range of an overlap whose middle line is the contact locus and whose half-length falls towards its ends as that of
/// an ellipse. The wheel is `lower` below its place [m].
void addExtent(const PlacedWheel& wheel, const OverlapInterval& interval, double lower, Extent& extent)
{
  const double shift = interval.contact.wheel_u - interval.contact.rail_u;
  Extent locus;
  for (const double u : {interval.contact.wheel_u, interval.u_begin + shift, interval.u_end + shift})
  {
    SpacePoint point{};
    if (wheel.locus(wheel.profile().at(u), point))
    {
      locus.least = std::min(locus.least, point.x);
      locus.most = std::max(locus.most, point.x);
    }
  }
  // A wheel circle that overlaps by a depth below its lowest point does so over this length.
  const double radius = wheel.sections().radius - wheel.profile().at(interval.contact.wheel_u).z;
  const double spread = locus.most - locus.least;
  const double half =
      0.15 * spread +
      std::hypot(0.5 * spread, std::sqrt(2 * std::max(lower - interval.contact.separation, 0.0) * radius));
  const double middle = 0.5 * (locus.least + locus.most);
  extent.least = std::min(extent.least, middle - half);
  extent.most = std::max(extent.most, middle + half);
}

/// Adds a part of its length and width to each side of an area.
void grow(double along, double across, SurfaceArea& area)
{
  const double length = area.x_most - area.x_least, width = area.arc_most - area.arc_least;
  area.x_least -= along * length;
  area.x_most += along * length;
  area.arc_least -= across * width;
  area.arc_most += across * width;
}

/// Leaves columns out that a vertical displacement hardly opens, or closes.
void leaveOutWalls(const std::vector<SurfaceColumn>& columns, PatchGap& patch)
{
  for (Eigen::Index j = 0; j < patch.grid.ny; ++j)
  {
    if (columns[static_cast<std::size_t>(j)].perUp() < smallest_opening)
    {
      patch.gap.col(j).setConstant(no_body_gap);
    }
  }
}

/// Sets weights and normals of the columns. The reference is the column with the deepest overlap.
/// @param spare  memory of `turn` while the normals hardly turn
void setNormals(const std::vector<SurfaceColumn>& columns, PatchGap& patch, Eigen::ArrayXd& spare)
{
  const auto at = [&](Eigen::Index j) -> const SurfaceColumn& { return columns[static_cast<std::size_t>(j)]; };
  const auto lowest = [&](Eigen::Index j) { return patch.gap.col(j).minCoeff(); };
  Eigen::Index row = 0, deepest = 0;
  patch.gap.minCoeff(&row, &deepest);
  patch.weight = std::max(at(deepest).perUp(), smallest_opening);
  patch.column_weight.resize(patch.grid.ny);
  double turn_least = 0, turn_most = 0;
  for (Eigen::Index j = 0; j < patch.grid.ny; ++j)
  {
    patch.column_weight[j] = std::max(at(j).perUp(), smallest_opening) / patch.weight;
    const double turn = lowest(j) < 0 ? at(j).turnFrom(at(deepest)) : 0;
    turn_least = std::min(turn_least, turn);
    turn_most = std::max(turn_most, turn);
  }
  const bool turns = turn_most - turn_least > plane_turn;
  if (turns != (patch.turn.size() > 0))
  {
    patch.turn.swap(spare);
  }
  patch.turn.resize(turns ? patch.grid.ny : 0);
  for (Eigen::Index j = 0; j < patch.turn.size(); ++j)
  {
    patch.turn[j] = at(j).angle() - at(deepest).angle();
  }
}

/// Slope of the gap across the track at the middle of a column: on the normal of a rail that turns by k per unit of its
/// arc, a body at the height g moves past by 1 - k g.
double gapSlope(const std::vector<SurfaceColumn>& columns, const PatchGap& patch, Eigen::Index j)
{
  const auto at = [&](Eigen::Index i) -> const SurfaceColumn& { return columns[static_cast<std::size_t>(i)]; };
  const double turn = at(j + 1).turnFrom(at(j - 1)) / (2 * patch.grid.dy);
  const Eigen::Index middle = patch.grid.symmetric ? 0 : patch.gap.rows() / 2;
  return at(j).wheel_slope * (1 - turn * patch.gap(middle, j));
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
}  // namespace

OverlapGrids::OverlapGrids(const Profile& wheel, const WheelsetConfig& wheelset, const Profile& rail)
    : wheel_(wheel), wheelset_(wheelset), search_(wheel, rail)
{
  laid_.reserve(usual_grids);
  before_.reserve(usual_grids);
}

void OverlapGrids::setRail(const PlacedRail& rail)
{
  rail_ = rail;
  search_.setRail(rail);
}

OverlapGrids::Overlap OverlapGrids::build(const WheelsetPose& pose, const GridSize& size, Choice choice,
                                          NormalProblem& problem)
{
  placed_wheel_.emplace(wheel_, wheelset_, pose);
  const PlacedWheel& wheel = *placed_wheel_;
  search_.setWheel(wheel);
  if (!search_.nearest(touch_))
  {
    return Overlap::beside;
  }
  if (!(touch_.separation < -least_overlap))
  {
    return Overlap::none;
  }
  search_.overlapIntervals(0, intervals_);
  std::swap(before_, laid_);
  laid_.clear();
  for (std::size_t k = problem.patches.size(); k > 0; --k)
  {
    removeLast(problem);
  }
  for (std::size_t first = 0; first < intervals_.size(); first = endOfGroup(first))
  {
    addGrid(wheel, first, endOfGroup(first), size, choice, problem);
  }
  couple(problem);
  return problem.patches.empty() ? Overlap::beside : Overlap::found;
}

/// End (exclusive) of the intervals from `first` on that are in one grid: each is closer to the next than the wider of
/// them is wide.
std::size_t OverlapGrids::endOfGroup(std::size_t first) const
{
  const auto width = [this](std::size_t k) { return intervals_[k].u_end - intervals_[k].u_begin; };
  double widest = width(first);
  std::size_t end = first + 1;
  while (end < intervals_.size() && intervals_[end].u_begin - intervals_[end - 1].u_end < std::max(widest, width(end)))
  {
    widest = std::max(widest, width(end++));
  }
  return end;
}

bool OverlapGrids::fits(double lower)
{
  search_.overlapIntervals(lower, intervals_);
  std::size_t count = 0;
  for (std::size_t first = 0; first < intervals_.size(); first = endOfGroup(first), ++count)
  {
    const GridSize size{laid_.front().used.grid.nx, laid_.front().used.grid.ny};
    const SurfaceArea area = areaOf(*placed_wheel_, first, endOfGroup(first), lower);
    if (count >= laid_.size() || laid_[count].reserved ||
        !layGrid(area, size, laid_.front().used.grid.symmetric).equals(laid_[count].planned))
    {
      return false;
    }
  }
  return count == laid_.size();
}

/// The area of the intervals from `first` to `last` (exclusive) of a wheel that is `lower` below its place [m], with a
/// margin. Its origin is the deepest place.
SurfaceArea OverlapGrids::areaOf(const PlacedWheel& wheel, std::size_t first, std::size_t last, double lower) const
{
  const OverlapInterval* const begin = &intervals_[first];
  const OverlapInterval* const end = begin + (last - first);
  const InitialContact& deepest = std::min_element(begin, end,
                                                   [](const OverlapInterval& one, const OverlapInterval& other)
                                                   { return one.contact.separation < other.contact.separation; })
                                      ->contact;
  Extent along;
  std::for_each(begin, end, [&](const OverlapInterval& interval) { addExtent(wheel, interval, lower, along); });
  const Profile& profile = rail_->profile();
  SurfaceArea area{along.least,
                   along.most,
                   arcLength(profile, deepest.rail_u, begin->u_begin),
                   arcLength(profile, deepest.rail_u, (end - 1)->u_end),
                   {0, deepest.rail_u, deepest.wheel_u}};
  grow(margin_along, margin, area);
  return area;
}

/// A grid of the last call that covers the area; null if there is none.
const OverlapGrids::Laid* OverlapGrids::laidBefore(const SurfaceArea& area, const GridSize& size, Choice choice) const
{
  const double most_larger = choice == Choice::kept ? most_larger_kept : most_larger_reserved;
  for (const Laid& laid : before_)
  {
    const double shift = arcLength(rail_->profile(), laid.used.origin.rail_u, area.origin.rail_u);
    if (GridSize{laid.used.grid.nx, laid.used.grid.ny} == size &&
        laid.used.grid.symmetric == (placed_wheel_->pose().yaw == 0) && covers(laid.used, area, shift, most_larger))
    {
      return &laid;
    }
  }
  return nullptr;
}

/// Adds the grid over the intervals `first` to `last` (exclusive), if there are columns that overlap.
void OverlapGrids::addGrid(const PlacedWheel& wheel, std::size_t first, std::size_t last, const GridSize& size,
                           Choice choice, NormalProblem& problem)
{
  const bool symmetric = wheel.pose().yaw == 0;
  SurfaceArea area = areaOf(wheel, first, last, 0);
  const Laid* const before = choice != Choice::own ? laidBefore(area, size, choice) : nullptr;
  const GridLayout fresh = layGrid(area, size, symmetric);
  const bool reserved = choice == Choice::reserved && before == nullptr;
  if (reserved)
  {
    grow(reserve, reserve, area);
  }
  Laid laid = before != nullptr ? *before : Laid{fresh, layGrid(area, size, symmetric), reserved};
  GridLayout& layout = laid.used;
  appendPatch(problem);
  PatchGap& patch = problem.patches.back();
  std::vector<SurfaceColumn>& columns = columns_.back();
  for (int k = 0; k < most_widenings; ++k)
  {
    patch.grid = layout.grid;
    if (!buildSurfaceGap(wheel, *rail_, layout.origin, layout.grid, patch.gap, columns))
    {
      break;
    }
    leaveOutWalls(columns, patch);
    const bool long_enough = !isCutAlong(patch), wide_enough = !isCutAcross(patch);
    if (long_enough && wide_enough)
    {
      if (!(patch.gap.minCoeff() < 0))
      {
        break;
      }
      setNormals(columns, patch, spare_turn_);
      fillUnseenSlope(patch, [&](Eigen::Index j) { return gapSlope(columns, patch, j); });
      laid_.push_back(laid);
      return;
    }
    grow(long_enough ? 0 : widening, wide_enough ? 0 : widening, area);
    layout = layGrid(area, size, symmetric);
  }
  removeLast(problem);
}

/// Appends a patch, with the memory of a removed one if there is any.
void OverlapGrids::appendPatch(NormalProblem& problem)
{
  if (spare_patches_.empty())
  {
    problem.patches.emplace_back();
    columns_.emplace_back();
    return;
  }
  problem.patches.push_back(std::move(spare_patches_.back()));
  columns_.push_back(std::move(spare_columns_.back()));
  spare_patches_.pop_back();
  spare_columns_.pop_back();
}

void OverlapGrids::removeLast(NormalProblem& problem)
{
  spare_patches_.push_back(std::move(problem.patches.back()));
  spare_columns_.push_back(std::move(columns_.back()));
  problem.patches.pop_back();
  columns_.pop_back();
}

/// Sets the displacement of the columns of each grid by the forces in the columns of the others: that of a point force
/// on a half-space (Johnson 1985, eq. 3.22b), at the root mean square distance of two half-ellipses along the track,
/// and projected onto the normal.
void OverlapGrids::couple(NormalProblem& problem)
{
  if ((problem.patches.size() > 1) != (problem.coupling.size() > 0))
  {
    problem.coupling.swap(spare_coupling_);
  }
  if (problem.patches.size() < 2)
  {
    return;
  }
  Eigen::Index count = 0;
  for (const PatchGap& patch : problem.patches)
  {
    count += patch.grid.ny;
  }
  problem.coupling.setZero(count, count);
  Eigen::Index row = 0;
  for (std::size_t k = 0; k < problem.patches.size(); row += problem.patches[k++].grid.ny)
  {
    Eigen::Index column = row + problem.patches[k].grid.ny;
    for (std::size_t l = k + 1; l < problem.patches.size(); column += problem.patches[l++].grid.ny)
    {
      const Grid &one = problem.patches[k].grid, &other = problem.patches[l].grid;
      // The pressure is about 1 / sqrt(2) as long as the overlap; the variance of a half-ellipse is a quarter of the
      // square of its half-length.
      const auto variance = [](const Grid& grid) { return std::pow(0.5 * grid.nx * grid.dx, 2) / 8; };
      const double along = std::pow(originOf(k).x - originOf(l).x, 2) + variance(one) + variance(other);
      for (Eigen::Index i = 0; i < one.ny; ++i)
      {
        const SurfaceColumn& here = columns_[k][static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < other.ny; ++j)
        {
          const SurfaceColumn& there = columns_[l][static_cast<std::size_t>(j)];
          const double distance = std::sqrt(along + std::pow(here.y - there.y, 2) + std::pow(here.z - there.z, 2));
          problem.coupling(row + i, column + j) = problem.coupling(column + j, row + i) =
              (here.cosine * there.cosine + here.sine * there.sine) / (pi * problem.modulus * distance);
        }
      }
    }
  }
}
}  // namespace wheel_rail_contact::core
