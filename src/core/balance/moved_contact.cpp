// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/moved_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/balance/patch_result.h"
#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr int roll_movement = 2;
/// Movements for the differences of the geometry [m], [rad]: small against an overlap, large against the accuracy of
/// the points of a gap. A yaw hardly changes the gap of cells that move with the contact.
constexpr std::array<double, MovedContact::movements> small_movements{1e-6, 1e-6, 1e-6, 5e-5};
/// Share of them for cells at the edge of the contact: their pressure must not vanish.
constexpr double share_at_edge = 1e-3;

constexpr int force_x = 0, force_y = 1, force_z = 2, moment_x = 3, moment_y = 4, moment_z = 5;
}  // namespace

double MovedContact::stepOf(int movement)
{
  return share_at_edge * small_movements[static_cast<std::size_t>(movement)];
}

Eigen::Matrix<double, MovedContact::movements, MovedContact::movements> MovedContact::byAxle() const
{
  const PlanePoint head = contact_->rail().referencePoint();
  const double sign = sideSign(side_);
  Eigen::Matrix<double, movements, movements> all = Eigen::Vector4d(sign, 1, sign, sign).asDiagonal();
  all.col(roll_movement).head<2>() << sign * (axle_.z - head.z), sign * (head.y - axle_.y);
  return all;
}

Eigen::Matrix<double, MovedContact::movements, 3> MovedContact::byRail()
{
  Eigen::Matrix<double, movements, 3> all = Eigen::Matrix<double, movements, 3>::Zero();
  all.diagonal() << -1, -1, 1;
  return all;
}

WheelsetPose MovedContact::moved(int movement, double step) const
{
  WheelsetPose axle = axle_;
  const std::array<double*, movements> all{&axle.y, &axle.z, &axle.roll, &axle.yaw};
  *all[static_cast<std::size_t>(movement)] += step;
  if (movement == roll_movement)
  {
    const PlanePoint head = contact_->rail().referencePoint();
    axle.y -= step * (axle_.z - head.z);
    axle.z += step * (axle_.y - head.y);
  }
  return toSide(side_, axle);
}

/// Builds the gaps of an axle, track axes, on the cells of the solution. The cells move along the track with the
/// contact: a yaw moves it by far more than it changes it, and a fixed grid would add its own ripple.
void MovedContact::build(const WheelsetPose& axle, Cells& cells)
{
  const std::size_t count = problem_->patches.size();
  const PlacedWheel wheel(*config_->wheel_profile[side_], config_->wheelset, side_, toSide(side_, axle),
                          contact_->rail().rim().rise),
      before = contact_->wheel();
  cells.patches.resize(count);
  cells.columns.resize(count);
  cells.x.resize(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    PatchGap& patch = cells.patches[k];
    patch.grid = problem_->patches[k].grid;
    SurfaceOrigin origin = contact_->grids().originOf(k);
    const CurvePoint middle = wheel.profile().at(origin.wheel_u);
    origin.x += wheel.locusX(middle) - before.locusX(middle);
    cells.x[k] = origin.x;
    buildSurfaceGap(wheel, contact_->rail(), origin, patch.grid, patch.gap, slope_, cells.columns[k]);
    leaveOutWalls(cells.columns[k], patch);
    raiseByCells(patch);
  }
}

/// Outputs after a movement. As in a result, each island acts at its centre of pressure; only the moment about x is
/// that of the columns.
MovedContact::Outputs MovedContact::sum(int movement, int direction) const
{
  const double step = direction * small_movements[static_cast<std::size_t>(movement)], sign = sideSign(side_);
  const Cells& cells = cells_[static_cast<std::size_t>(movement)][direction > 0 ? 1 : 0];
  const WheelsetPose axle = toSide(side_, moved(movement, step));
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  for (const Island& island : *islands_)
  {
    const std::size_t k = island.patch;
    const Grid& grid = cells.patches[k].grid;
    const Eigen::ArrayXXd &pressure = solution_->patches[k].pressure,
                          &change = pressures_[static_cast<std::size_t>(movement)][k];
    double whole = 0, lever_x = 0, lever_y = 0, lever_z = 0;  // [N], [N m]
    Eigen::Matrix<double, 6, 1> part = Eigen::Matrix<double, 6, 1>::Zero();
    AlongShape along{0, 0};  // weighted with the forces
    for (Eigen::Index j = island.begin; j < island.begin + island.columns; ++j)
    {
      double force = 0;
      for (int i = 0; i < grid.nx; ++i)
      {
        const double in_cell = grid.cellArea() * (pressure(i, j) + step * change(i, j));
        force += in_cell;
        lever_x += in_cell * (cells.x[k] + grid.x(i));
      }
      if (force == 0)
      {
        continue;
      }
      const SurfaceColumn& column = cells.columns[k][static_cast<std::size_t>(j)];
      const double y = force * column.perOutward(), z = force * column.perUp();
      const double arm_y = column.y - axle.y, arm_z = column.z - axle.z;
      whole += force;
      lever_y += force * arm_y;
      lever_z += force * arm_z;
      part[force_y] += y;
      part[force_z] += z;
      part[moment_x] += arm_y * z - arm_z * y;
      const AlongShape own = contact_->rail().ownAlong(column.rail_u);
      along.slope += force * own.slope;
      along.curvature += force * own.curvature;
    }
    const double x = lever_x / whole;
    part[force_x] = -along.slopeAt(x);
    part[moment_y] = lever_z / whole * part[force_x] - x * part[force_z];
    part[moment_z] = x * part[force_y] - lever_y / whole * part[force_x];
    sum += part;
  }
  const PlanePoint head = contact_->rail().referencePoint();
  const double about_head = sum[moment_x] - (axle.z - head.z) * sum[force_y] + (axle.y - head.y) * sum[force_z];
  return (Outputs() << sum[0], sign * sum[1], sum[2], sign * sum[3], sum[4], sign * sum[5], -sum[force_y],
          -sum[force_z], about_head)
      .finished();
}

void MovedContact::find(const ContactModelConfig& config, Side side, const WheelContact& contact,
                        const Islands& islands, const WheelsetPose& axle)
{
  config_ = &config;
  side_ = side;
  contact_ = &contact;
  islands_ = &islands.islands();
  axle_ = toSide(side, axle);
  problem_ = &contact.problem();
  solution_ = &contact.solution();
  if (problem_->patches.front().grid.symmetric)
  {
    unfold();
  }
  openings_.resize(movements);
  for (int m = 0; m < movements; ++m)
  {
    const double step = small_movements[static_cast<std::size_t>(m)];
    auto& [behind, ahead] = cells_[static_cast<std::size_t>(m)];
    build(moved(m, -step), behind);
    build(moved(m, step), ahead);
    std::vector<Eigen::ArrayXXd>& openings = openings_[static_cast<std::size_t>(m)];
    openings.resize(ahead.patches.size());
    for (std::size_t k = 0; k < openings.size(); ++k)
    {
      openings[k] = (ahead.patches[k].gap - behind.patches[k].gap) / (2 * step);
    }
  }
  tangent_.pressures(*problem_, *solution_, openings_, pressures_);
  for (int m = 0; m < movements; ++m)
  {
    const Outputs ahead = sum(m, 1), behind = sum(m, -1);
    changes_.col(m) = (ahead - behind) / (2 * small_movements[static_cast<std::size_t>(m)]);
    values_ = 0.5 * (ahead + behind);
  }
}

/// Copies problem and pressure to whole grids: a yaw changes a symmetric pressure to one that is not.
void MovedContact::unfold()
{
  whole_problem_ = *problem_;
  whole_solution_.patches.resize(problem_->patches.size());
  for (std::size_t k = 0; k < problem_->patches.size(); ++k)
  {
    wholePressure(Side::left, problem_->patches[k].grid, solution_->patches[k].pressure,
                  whole_solution_.patches[k].pressure);
    whole_problem_.patches[k].grid.symmetric = false;
  }
  problem_ = &whole_problem_;
  solution_ = &whole_solution_;
}

PressedGrid MovedContact::pressed(int movement, int direction, std::size_t patch)
{
  const double step = direction * stepOf(movement), first = 0.5 - 0.5 * direction * share_at_edge, second = 1 - first;
  const auto& [behind, ahead] = cells_[static_cast<std::size_t>(movement)];
  const Eigen::ArrayXXd& change = pressures_[static_cast<std::size_t>(movement)][patch];
  pressure_ = (solution_->patches[patch].pressure + step * change).max(0.0);
  gap_ = ahead.patches[patch];
  gap_.gap = first * behind.patches[patch].gap + second * gap_.gap;
  columns_ = ahead.columns[patch];
  for (std::size_t j = 0; j < columns_.size(); ++j)
  {
    columns_[j].mean_slope = first * behind.columns[patch][j].mean_slope + second * columns_[j].mean_slope;
  }
  const double x = first * behind.x[patch] + second * ahead.x[patch];
  return {gap_, pressure_, columns_, x, moved(movement, step), contact_->rail().referencePoint()};
}

MovedContact::Outputs rolledOutward(Side side, const MovedContact::Outputs& forces)
{
  const double sign = sideSign(side);
  MovedContact::Outputs change;
  change << 0, sign * forces[force_z], -sign * forces[force_y], 0, sign * forces[moment_z], -sign * forces[moment_y],
      forces[7], -forces[6], 0;
  return change;
}
}  // namespace wheel_rail_contact::core
