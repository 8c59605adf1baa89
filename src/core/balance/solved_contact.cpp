// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/solved_contact.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
/// Coordinates of what SolvedContact::openings() has: those of a force or movement are coordinates() times it.
Eigen::Matrix<double, motions, 4> coordinates()
{
  Eigen::Matrix<double, motions, 4> all = Eigen::Matrix<double, motions, 4>::Zero();
  all(wheel_up, 0) = all(wheel_roll, 1) = all(rail_lateral, 2) = all(rail_roll, 3) = 1;
  all(rail_up, 0) = -1;
  return all;
}

/// Turn of the wheel from one column to another [rad], small.
double wheelTurn(const SurfaceColumn& from, const SurfaceColumn& to)
{
  return to.turnFrom(from) + to.wheel_slope - from.wheel_slope;
}
}  // namespace

/// Product of each coordinate with a vector at a column. A roll moves the wheel by -(z - z_axle) outward and by
/// y - y_axle upwards.
MotionVector SolvedContact::moved(const SurfaceColumn& column, double outward, double up) const
{
  MotionVector all;
  all << up, -(column.z - axle_.z) * outward + (column.y - axle_.y) * up, -outward, -up,
      -(column.z - reference_.z) * outward + (column.y - reference_.y) * up;
  return all;
}

void SolvedContact::clear()
{
  loaded_.clear();
  forces_.setZero();
  energy_ = 0;
}

void SolvedContact::set(const std::vector<std::vector<SurfaceColumn>>& columns, const CurvedProblem& problem,
                        const NormalSolution& solution, const PlanePoint& axle, const PlanePoint& reference)
{
  clear();
  axle_ = axle;
  reference_ = reference;
  under_load_ = problem.control == NormalProblem::Control::load;
  openings_.resize(problem.patches.size());
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    const auto& [grid, gap, unseen_slope, weight] = problem.patches[k];
    const Eigen::ArrayXXd& pressure = solution.patches[k].pressure;
    column_forces_ = grid.cellArea() * pressure.colwise().sum().transpose().matrix();
    openings_[k].resize(grid.ny, 4);
    for (Eigen::Index j = 0; j < grid.ny; ++j)
    {
      const auto at = [&](Eigen::Index i) -> const SurfaceColumn& { return columns[k][static_cast<std::size_t>(i)]; };
      const MotionVector opening = moved(at(j), at(j).perOutward(), at(j).perUp());
      openings_[k].row(j) << opening[wheel_up], opening[wheel_roll], opening[rail_lateral], opening[rail_roll];
      if (column_forces_[j] > 0)
      {
        const Eigen::Index before = std::max<Eigen::Index>(j - 1, 0),
                           after = std::min<Eigen::Index>(j + 1, grid.ny - 1);
        const double curvature = wheelTurn(at(before), at(after)) / (static_cast<double>(after - before) * grid.dy);
        loaded_.push_back({at(j), opening, column_forces_[j], curvature, grid.dy,
                           (j == before || at(before).has_bodies) && (j == after || at(after).has_bodies)});
      }
    }
    const Eigen::Vector4d along = openings_[k].matrix().transpose() * column_forces_;
    forces_ += coordinates() * along;
    energy_ -= 0.5 * grid.cellArea() * (pressure * gap).sum();
  }
  energy_ += 0.5 * forces_[wheel_up] * solution.approach;
}

bool SolvedContact::isLoadedAtEnd(double wheel_end) const
{
  return std::any_of(loaded_.begin(), loaded_.end(),
                     [&](const LoadedColumn& one)
                     {
                       const double u = one.column.wheel_u;
                       return !one.at_bodies || u < one.width || u > wheel_end - one.width;
                     });
}

double SolvedContact::heightOverReference() const
{
  double force = 0, moment = 0;
  for (const LoadedColumn& one : loaded_)
  {
    force += one.force;
    moment += one.force * (one.column.z - reference_.z);
  }
  return force > 0 ? moment / force : 0;
}

double SolvedContact::opening(const MotionVector& move) const
{
  const double rise = under_load_ ? -forces_.dot(move) / forces_[wheel_up] : 0;
  double largest = 0;
  for (const LoadedColumn& one : loaded_)
  {
    largest = std::max(largest, std::abs(one.opening.dot(move) + rise * one.opening[wheel_up]));
  }
  return largest;
}

MotionVector SolvedContact::verticalStiffness(const ContactTangent::Forces& elastic) const
{
  return coordinates() * elastic - geometricStiffness().col(wheel_up);
}

MotionMatrix SolvedContact::stiffness(const ContactTangent::Stiffness& elastic) const
{
  return coordinates() * elastic * coordinates().transpose() - geometricStiffness();
}

/// Integral of the pressure times the second derivatives of the gap. A column sees the wheel move by e along the rail
/// and turn by w: with the curvature c of the wheel, the second derivatives are c e_k e_l - e_k w_l - w_k e_l, and for
/// a roll about a point minus the height over this point along the normal.
MotionMatrix SolvedContact::geometricStiffness() const
{
  MotionMatrix sum = MotionMatrix::Zero();
  MotionVector turn = MotionVector::Zero();
  turn[wheel_roll] = turn[rail_roll] = 1;
  for (const auto& [column, opening, force, curvature, width, at_bodies] : loaded_)
  {
    const MotionVector along = moved(column, column.cosine, column.sine);
    sum += force * (curvature * along * along.transpose() - along * turn.transpose() - turn * along.transpose());
    const auto height = [&at = column](const PlanePoint& point)
    { return -(at.y - point.y) * at.sine + (at.z - point.z) * at.cosine; };
    sum(wheel_roll, wheel_roll) -= force * height(axle_);
    sum(rail_roll, rail_roll) += force * height(reference_);
  }
  return sum;
}
}  // namespace wheel_rail_contact::core
