// SPDX-License-Identifier: BSD-3-Clause
#include "core/friction/rolling_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/balance/patch_result.h"
#include "core/constants.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
using Eigen::Vector3d;

namespace
{
/// Overlap of the undeformed bodies in a column of a grid at the height of the solution [m].
double overlapOf(const PressedGrid& grid, int side_column)
{
  const bool is_curved = grid.normals != nullptr && grid.normals->weight.size() > 0;
  const double weight = is_curved ? grid.normals->weight[side_column] : 1;
  return grid.approach * grid.gap.weight * weight - grid.gap.gap.col(side_column).minCoeff();
}

/// Centre of pressure of a column along the track [m]; 0 without pressure.
double centreOf(const CreepProblem& problem, int column)
{
  double sum = 0, moment = 0;
  for (int i = 0; i < problem.grid.nx; ++i)
  {
    sum += problem.pressure(i, column);
    moment += problem.pressure(i, column) * problem.grid.x(i);
  }
  return sum > 0 ? moment / sum : 0;
}
}  // namespace

void RollingContact::setMaterial(const ShearElasticity& elasticity, const FrictionLaw& friction)
{
  problem_.elasticity = elasticity;
  problem_.friction = friction;
}

void RollingContact::place(Side side, const WheelsetBalance& balance, std::size_t grid, const RailMotion& direction,
                           const RailRates& velocity)
{
  side_ = side;
  grid_ = grid;
  direction_ = direction;
  velocity_ = velocity;
  const WheelContact& contact = balance.wheel(side).contact();
  const CurvedProblem& problem = contact.problem();
  const SemiAxes ellipse = equalEllipse(contact.solution().patches[grid]);
  problem_.semi_axis_along = ellipse.along;
  problem_.semi_axis_across = ellipse.across;
  placeColumns({problem.patches[grid], contact.solution().patches[grid].pressure, contact.grids().columns()[grid],
                contact.grids().originOf(grid).x, balance.pose(), contact.rail().referencePoint(),
                contact.solution().approach, problem.normals.empty() ? nullptr : &problem.normals[grid]});
}

void RollingContact::placeMoved(const PressedGrid& grid)
{
  const bool is_joined = is_joined_;
  placeColumns(grid);
  if (is_joined)
  {
    strips_.measure(problem_);
    join(per_strips_);
  }
}

void RollingContact::placeColumns(const PressedGrid& grid)
{
  const Grid& cells = grid.gap.grid;
  const double first = (0.5 - 0.5 * cells.nx) * cells.dx;
  const double mirrored = -(cells.y0 + (cells.ny - 1) * cells.dy);
  problem_.grid = {cells.nx, cells.ny, cells.dx, cells.dy, first, side_ == Side::left ? cells.y0 : mirrored};
  wholePressure(side_, cells, grid.pressure, problem_.pressure);
  is_new_ = true;
  const double sign = sideSign(side_), area = problem_.grid.cellArea();
  head_ = {0, sign * grid.head.y - grid.axle.y, grid.head.z - grid.axle.z};
  const int count = problem_.grid.ny;
  const auto side_column = [&](int column) { return side_ == Side::left ? column : count - 1 - column; };
  columns_.resize(static_cast<std::size_t>(count));
  for (int j = 0; j < count; ++j)
  {
    const SurfaceColumn& at = grid.columns[static_cast<std::size_t>(side_column(j))];
    Column& column = columns_[static_cast<std::size_t>(j)];
    column.place = {};
    column.place.angle = sign * std::atan2(-at.perOutward(), at.perUp());
    column.on_rail = {grid.x, sign * at.y - grid.axle.y, at.z - grid.axle.z};
    column.overlap = overlapOf(grid, side_column(j));
    column.centre_x = centreOf(problem_, j);
    column.load = area * problem_.pressure.col(j).sum() * std::hypot(at.perOutward(), at.perUp());
  }
  const auto load = [&](int j) { return columns_[static_cast<std::size_t>(j)].load; };
  for (int j = 0; j < count; ++j)
  {
    double approach = 0;
    const auto deepen = [&](int k, double weight)
    { approach = std::max(approach, weight * columns_[static_cast<std::size_t>(k)].overlap); };
    visitConnected(count, j, load, deepen);
    ContactPlace& place = columns_[static_cast<std::size_t>(j)].place;
    place.position = columns_[static_cast<std::size_t>(j)].on_rail - approach * sectionNormal(place);
  }
  setRail();
  problem_.normal_force = 0;
  for (const Column& column : columns_)
  {
    problem_.normal_force += column.load;
  }
  whole_ = meanOf(0, static_cast<double>(count));
  is_joined_ = false;
}

/// Columns from one to another as one: at the centre of pressure, with the direction of the sum of their normal forces.
/// @param first, end  may lie in a column: a share of it counts
RollingContact::Column RollingContact::meanOf(double first, double end) const
{
  Column mean;
  double centre = 0, x = 0;
  Vector3d force = Vector3d::Zero();
  for (auto j = static_cast<std::size_t>(first); static_cast<double>(j) < end; ++j)
  {
    const Column& column = columns_[j];
    const double from = std::max(first, static_cast<double>(j)), to = std::min(end, static_cast<double>(j + 1));
    const double load = (to - from) * column.load;
    mean.load += load;
    centre += load * (0.5 * (from + to) - 0.5);
    x += load * column.centre_x;
    force += load * sectionNormal(column.place);
  }
  if (!(mean.load > 0))
  {
    return columns_[static_cast<std::size_t>(first)];
  }
  centre = std::max(0.0, centre / mean.load);
  const auto before = static_cast<std::size_t>(centre), after = std::min(before + 1, columns_.size() - 1);
  const double share = centre - static_cast<double>(before);
  mean.place = columns_[before].place;
  mean.place.position += share * (columns_[after].place.position - mean.place.position);
  mean.on_rail = columns_[before].on_rail + share * (columns_[after].on_rail - columns_[before].on_rail);
  mean.place.position.x() += x / mean.load;
  mean.on_rail.x() += x / mean.load;
  mean.place.angle = std::atan2(-force.y(), force.z());
  mean.axes = patchAxes(mean.place);
  return mean;
}

/// Index of a column of the side, or of the first ellipse from there on.
std::size_t RollingContact::indexOf(Eigen::Index side_column) const
{
  const auto column = static_cast<std::size_t>(side_column);
  const auto is_before = [&](const Column& ellipse) { return ellipse.highest < column; };
  return is_joined_ ? static_cast<std::size_t>(std::count_if(columns_.begin(), columns_.end(), is_before)) : column;
}

void RollingContact::join()
{
  strips_.measure(problem_);
  const CreepStrips::Ellipse strips = strips_.ellipseOf(problem_, 0, static_cast<double>(columns_.size()));
  const double a = problem_.semi_axis_along, b = problem_.semi_axis_across;
  join({pi * a * b / strips.area, a / (b * strips.ratio)});
}

void RollingContact::join(const CreepStrips::Ellipse& per_strips)
{
  per_strips_ = per_strips;
  ellipses_.clear();
  addEllipses(0, static_cast<double>(columns_.size()), 1);
  columns_.swap(ellipses_);
  is_joined_ = true;
}

/// Adds the ellipses of columns from one to another, which may lie in a column.
void RollingContact::addEllipses(double first, double end, double weight)
{
  const auto load = [&](std::size_t j) { return columns_[j].load; };
  const auto begin = static_cast<std::size_t>(first), last = static_cast<std::size_t>(std::ceil(end)) - 1;
  std::size_t highest = begin;
  for (std::size_t j = begin; j <= last; ++j)
  {
    highest = load(j) > load(highest) ? j : highest;
  }
  double least = 1, cut = end;
  const auto find_least = [&](std::size_t j, std::size_t step)  // up to the highest one
  {
    for (double most = 0; j != highest; most = std::max(most, load(j)), j += step)
    {
      if (load(j) < least * most)
      {
        least = load(j) / most;
        const double bend = load(j - 1) - 2 * load(j) + load(j + 1);  // the cut is at the vertex of the parabola
        const double vertex = bend > 0 ? 0.5 * (load(j - 1) - load(j + 1)) / bend : 0;
        cut = static_cast<double>(j) + 0.5 + std::clamp(vertex, -0.5, 0.5);
      }
    }
  };
  find_least(begin, 1);
  find_least(last, std::size_t(-1));
  if (least > 0)
  {
    const CreepStrips::Ellipse strips = strips_.ellipseOf(problem_, first, end);
    const double square = per_strips_.area * strips.area / pi, ratio = per_strips_.ratio * strips.ratio;
    Column& ellipse = ellipses_.emplace_back(meanOf(first, end));
    ellipse.highest = highest;
    ellipse.weight = weight * least;
    ellipse.semi_axis_along = std::sqrt(square * ratio);
    ellipse.semi_axis_across = std::sqrt(square / ratio);
  }
  if (cut < end)
  {
    addEllipses(first, cut, weight * (1 - least));
    addEllipses(cut, end, weight * (1 - least));
  }
}

/// Returns the first status that is not usable, or the last one.
CreepStatus RollingContact::solveEllipses()
{
  CreepStatus status = CreepStatus::converged;
  double error = 0;
  for (std::size_t k = 0; k < columns_.size() && isUsable(status); ++k)
  {
    Column& ellipse = columns_[k];
    problem_.creepage = problem_.columns[k];
    problem_.normal_force = ellipse.load;
    problem_.semi_axis_along = ellipse.semi_axis_along;
    problem_.semi_axis_across = ellipse.semi_axis_across;
    solver_->solve(problem_, true, solution_);
    const CreepForce& force = solution_.force;
    ellipse.force = {ellipse.weight * force.x, ellipse.weight * force.y, ellipse.weight * force.moment};
    error = std::max(error, solution_.error_estimate);
    status = solution_.status;
  }
  solution_.error_estimate = error;
  return status;
}

void RollingContact::setRail()
{
  const double sign = sideSign(side_);
  for (Column& column : columns_)
  {
    const Vector3d arm = column.on_rail - head_;
    const auto lateral = [&](const RailRates& rates) { return sign * (rates.lateral + rates.roll * arm.z()); };
    const auto vertical = [&](const RailRates& rates) { return rates.vertical - sign * rates.roll * arm.y(); };
    column.place.slope_y = lateral(direction_.slope) + column.on_rail.x() * lateral(direction_.bend);
    column.place.slope_z = vertical(direction_.slope) + column.on_rail.x() * vertical(direction_.bend);
    column.place.rail_velocity_y = lateral(velocity_);
    column.place.rail_velocity_z = vertical(velocity_);
    column.axes = patchAxes(column.place);
  }
}

CreepStatus RollingContact::solve(WheelsetMotion motion, bool follows)
{
  const ContactPlace place = centre();
  motion.vertical_velocity -= follows ? normalVelocity(motion, place) / patchAxes(place)(2, 2) : 0;
  motion_ = motion;
  problem_.speed = motion.speed;
  problem_.columns.resize(columns_.size());
  for (std::size_t j = 0; j < columns_.size(); ++j)
  {
    problem_.columns[j] = creepages(motion, columns_[j].place);
  }
  if (is_joined_)
  {
    return solveEllipses();
  }
  problem_.creepage = problem_.columns.front();
  std::exchange(is_new_, false) ? solver_->solve(problem_, true, solution_) : solver_->solveAgain(problem_, solution_);
  return solution_.status;
}

void RollingContact::forget()
{
  solution_.traction_x.resize(0, 0);
  solution_.traction_y.resize(0, 0);
}

Wrench RollingContact::onWheelset(std::size_t first, std::size_t end) const
{
  Wrench sum;
  for (std::size_t j = first; j < end; ++j)
  {
    const Eigen::Matrix3d& axes = columns_[j].axes;
    const CreepForce& friction = forceOf(j);
    const Vector3d force = friction.x * axes.col(0) + friction.y * axes.col(1);
    sum.force += force;
    sum.moment += columns_[j].place.position.cross(force) + friction.moment * axes.col(2);
  }
  return sum;
}

Vector3d RollingContact::onRail(bool with_lateral) const
{
  const double sign = sideSign(side_);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t j = 0; j < columns_.size(); ++j)
  {
    const Eigen::Matrix3d& axes = columns_[j].axes;
    Vector3d force = -(forceOf(j).x * axes.col(0) + forceOf(j).y * axes.col(1));
    const Vector3d arm = columns_[j].on_rail - head_;
    force.y() = with_lateral ? force.y() : 0;
    sum += Vector3d(sign * force.y(), force.z(), sign * (force.y() * arm.z() - force.z() * arm.y()));
  }
  return sum;
}

void RollingContact::addTo(const Island& island, bool with_field, PatchResult& patch) const
{
  const Eigen::Index begin = side_ == Side::left ? island.begin : problem_.grid.ny - island.begin - island.columns;
  const std::size_t first = indexOf(begin), end = indexOf(begin + island.columns);
  const Wrench wrench = onWheelset(first, end);
  const Column mean = is_joined_ ? columns_[first] : meanOf(static_cast<double>(first), static_cast<double>(end));
  const Eigen::Matrix3d& axes = mean.axes;
  PatchCreep& creep = patch.creep;
  creep.creepage = creepages(motion_, mean.place);
  const Vector3d force = axes.transpose() * wrench.force;
  creep.force = {force.x(), force.y(), axes.col(2).dot(wrench.moment - mean.place.position.cross(wrench.force))};
  creep.vertical_force = wrench.force.z();
  creep.lateral_force = -sideSign(side_) * wrench.force.y();
  patch.vertical_force += creep.vertical_force;
  patch.lateral_force += creep.lateral_force;
  double limit = 0, work = 0;
  for (std::size_t j = first; j < end; ++j)
  {
    limit += columns_[j].weight * columns_[j].load * frictionOf(problem_, static_cast<int>(j));
    work += workOf(forceOf(j), problem_.columns[j]);
  }
  creep.adhesion_share = limit > 0 ? std::hypot(creep.force.x, creep.force.y) / limit : 0;
  creep.power = std::abs(motion_.speed) * work;
  creep.error_estimate = solution_.error_estimate;
  if (with_field && solution_.traction_x.cols() == problem_.grid.ny)
  {
    creep.traction_x = solution_.traction_x.middleCols(begin, island.columns);
    creep.traction_y = solution_.traction_y.middleCols(begin, island.columns);
  }
}
}  // namespace wheel_rail_contact::core
