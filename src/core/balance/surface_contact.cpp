// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/surface_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double margin = 0.02;            ///< width of the grid beyond each end of the overlap, over its width [-]
constexpr double typical_load = 1e5;       ///< [N]; under it the overlap is about typical_overlap
constexpr double typical_overlap = 6e-5;   ///< [m]
constexpr double smallest_opening = 0.05;  ///< columns that a vertical displacement opens by less are left out [-]
constexpr int most_solutions = 60;         ///< bisection alone needs fewer

/// Range of the contact locus along the track over the overlap, and half the length of the overlap about it [m].
struct Extent
{
  double x_least, x_most, half;
};

Extent extentAlong(const PlacedWheel& wheel, const std::vector<OverlapInterval>& intervals, double depth)
{
  Extent extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
  double radius = 0;
  for (const OverlapInterval& interval : intervals)
  {
    const double shift = interval.contact.wheel_u - interval.contact.rail_u;
    for (const double u : {interval.contact.wheel_u, interval.u_begin + shift, interval.u_end + shift})
    {
      const CurvePoint point = wheel.profile().at(u);
      SpacePoint locus{};
      if (wheel.locus(point, locus))
      {
        extent.x_least = std::min(extent.x_least, locus.x);
        extent.x_most = std::max(extent.x_most, locus.x);
      }
      radius = std::max(radius, wheel.sections().radius - point.z);
    }
  }
  // A wheel circle that overlaps by `depth` below its lowest point does so over this length.
  extent.half = std::sqrt(2 * depth * radius);
  return extent;
}
}  // namespace

SurfaceContact::SurfaceContact(const Profile& wheel, const WheelsetConfig& wheelset, const PlacedRail& rail,
                               double modulus, ConjugateGradients& solver, const SurfaceContactOptions& options)
    : wheel_(wheel),
      wheelset_(wheelset),
      rail_(rail),
      solver_(solver),
      options_(options),
      search_(wheel, rail.profile())
{
  search_.setRail(rail_);
  problem_.modulus = modulus;
  problem_.patches.resize(1);
}

SurfaceContact::Overlap SurfaceContact::build(const WheelsetPose& pose)
{
  gap_height_ = height_ = pose.z;
  axle_y_ = pose.y;
  const PlacedWheel wheel(wheel_, wheelset_, pose);
  search_.setWheel(wheel);
  if (!search_.nearest(touch_))
  {
    return Overlap::beside;
  }
  if (!(touch_.separation < 0))
  {
    return Overlap::none;
  }
  search_.overlapIntervals(0, intervals_);
  if (intervals_.empty())
  {
    return Overlap::none;
  }
  PatchGap& patch = problem_.patches[0];
  const SurfaceOrigin origin = layGrid(wheel, patch.grid);
  const bool built = buildSurfaceGap(wheel, rail_, origin, patch.grid, patch.gap, columns_) && setNormals(patch);
  return built ? Overlap::found : Overlap::beside;
}

/// Lays the grid over the overlap. Returns its origin.
SurfaceOrigin SurfaceContact::layGrid(const PlacedWheel& wheel, Grid& grid) const
{
  const Extent along = extentAlong(wheel, intervals_, overlap());
  const double half = (1 + margin) * (along.half + 0.5 * (along.x_most - along.x_least));
  const Profile& profile = rail_.profile();
  const double begin = intervals_.front().u_begin;
  const double width = arcLength(profile, begin, intervals_.back().u_end);
  grid.nx = options_.cells_along;
  grid.ny = options_.cells_across;
  grid.dx = 2 * half / grid.nx;
  grid.dy = (1 + 2 * margin) * width / grid.ny;
  grid.y0 = arcLength(profile, touch_.rail_u, begin) - margin * width + 0.5 * grid.dy;
  grid.symmetric = wheel.pose().yaw == 0;
  return {0.5 * (along.x_least + along.x_most), touch_.rail_u, touch_.wheel_u};
}

/// Sets weights and normals of the columns. The reference is the column with the deepest overlap. Columns that a
/// vertical displacement hardly opens, or closes, are left out. Returns false if no column overlaps.
bool SurfaceContact::setNormals(PatchGap& patch)
{
  const int columns = patch.grid.ny;
  int deepest = -1;
  double least = 0;
  for (int j = 0; j < columns; ++j)
  {
    if (columns_[static_cast<std::size_t>(j)].perUp() < smallest_opening)
    {
      patch.gap.col(j).setConstant(no_body_gap);
    }
    const double lowest = patch.gap.col(j).minCoeff();
    deepest = lowest < least ? j : deepest;
    least = std::min(least, lowest);
  }
  if (deepest < 0)
  {
    return false;
  }
  const SurfaceColumn& reference = columns_[static_cast<std::size_t>(deepest)];
  patch.weight = reference.perUp();
  patch.column_weight.resize(columns);
  patch.turn.resize(options_.turned_normals ? columns : 0);
  for (int j = 0; j < columns; ++j)
  {
    const SurfaceColumn& column = columns_[static_cast<std::size_t>(j)];
    patch.column_weight[j] = std::max(column.perUp(), smallest_opening) / patch.weight;
    if (options_.turned_normals)
    {
      patch.turn[j] = column.angle - reference.angle;
    }
  }
  return true;
}

/// Removes the last solution.
SolveStatus SurfaceContact::fail(SolveStatus status)
{
  solution_.patches.clear();
  solution_.approach = 0;
  solution_.status = status;
  return status;
}

SolveStatus SurfaceContact::solve(NormalProblem::Control control, double value)
{
  problem_.control = control;
  problem_.value = value;
  solver_.solve(problem_, false, solution_);
  ++solutions_;
  return solution_.status;
}

SolveStatus SurfaceContact::solveAt(const WheelsetPose& pose)
{
  solutions_ = 0;
  const Overlap overlap = build(pose);
  if (overlap != Overlap::found)
  {
    return fail(overlap == Overlap::none ? SolveStatus::no_contact : SolveStatus::invalid_problem);
  }
  return solve(NormalProblem::Control::approach, 0);
}

SolveStatus SurfaceContact::pass(const WheelsetPose& pose, double load)
{
  const double lowering = load > 0 ? typical_overlap * std::cbrt(std::pow(load / typical_load, 2)) : 0;
  WheelsetPose at = pose;
  for (int i = 0; i < most_solutions && load > 0; ++i)
  {
    const Overlap overlap = build(at);
    if (overlap == Overlap::found)
    {
      const SolveStatus status = solve(NormalProblem::Control::load, load);
      height_ = at.z - solution_.approach;
      return status;
    }
    if (overlap == Overlap::beside)
    {
      break;
    }
    at.z -= touch_.separation + lowering;
  }
  return fail(SolveStatus::invalid_problem);
}

SolveStatus SurfaceContact::solveLoad(const WheelsetPose& pose, double load)
{
  double too_low = -std::numeric_limits<double>::infinity(), too_high = std::numeric_limits<double>::infinity();
  WheelsetPose at = pose;
  solutions_ = 0;
  while (solutions_ < most_solutions)
  {
    const SolveStatus status = pass(at, load);
    // A positive approach that remains under the load: the wheel is too high by it.
    if (!isUsable(status) || std::abs(remaining()) <= options_.approach * overlap())
    {
      return status;
    }
    too_high = remaining() > 0 ? std::min(too_high, gap_height_) : too_high;
    too_low = remaining() > 0 ? too_low : std::max(too_low, gap_height_);
    at.z = height_;
    if (!(at.z > too_low && at.z < too_high))
    {
      at.z = 0.5 * (too_low + too_high);
    }
  }
  return fail(SolveStatus::iteration_limit);
}

double SurfaceContact::heightPerRoll()
{
  if (!isUsable(solution_.status) || solution_.patches.empty())
  {
    return 0;
  }
  openings_.resize(1);
  Eigen::ArrayXXd& openings = openings_.front();
  openings.resize(static_cast<Eigen::Index>(columns_.size()), 2);
  for (std::size_t j = 0; j < columns_.size(); ++j)
  {
    const SurfaceColumn& column = columns_[j];
    // A roll moves the wheel by -(z - z_axle) outward and by y - y_axle upwards.
    const double by_roll = -(column.z - gap_height_) * column.perOutward() + (column.y - axle_y_) * column.perUp();
    openings.row(static_cast<Eigen::Index>(j)) << column.perUp(), by_roll;
  }
  const Eigen::VectorXd change = tangent_.stiffness(problem_, solution_, openings_, 0);
  return change[0] > 0 ? -change[1] / change[0] : 0;
}

double SurfaceContact::columnForce(std::size_t column) const
{
  return problem_.patches[0].grid.cellArea() *
         solution_.patches[0].pressure.col(static_cast<Eigen::Index>(column)).sum();
}

double SurfaceContact::verticalForce() const
{
  double force = 0;
  for (std::size_t j = 0; j < columns_.size() && !solution_.patches.empty(); ++j)
  {
    force += columnForce(j) * columns_[j].perUp();
  }
  return force;
}

double SurfaceContact::outwardForce() const
{
  double force = 0;
  for (std::size_t j = 0; j < columns_.size() && !solution_.patches.empty(); ++j)
  {
    force -= columnForce(j) * columns_[j].perOutward();
  }
  return force;
}

double SurfaceContact::energy() const
{
  if (solution_.patches.empty())
  {
    return 0;
  }
  const PatchGap& patch = problem_.patches[0];
  return -0.5 * patch.grid.cellArea() * (solution_.patches[0].pressure * patch.gap).sum();
}
}  // namespace wheel_rail_contact::core
