// SPDX-License-Identifier: BSD-3-Clause
#include "polonsky_keer.h"

#include <algorithm>
#include <cmath>

#include "core/normal/operator/operator_cache.h"

namespace wheel_rail_contact
{
namespace
{
constexpr double no_surface = 1e9;  ///< gap of the padding cells of the fields [m]
constexpr int most_iterations = 500;
}  // namespace

void PolonskyKeer::begin(const core::NormalProblem& problem)
{
  const core::PatchGap& patch = problem.patches[0];
  const core::Grid& grid = patch.grid;
  static core::OperatorCache cache;
  influence_ = cache.find(grid.nx, grid.ny, grid.symmetric, grid.dx / grid.dy);
  size_ = influence_->fieldSize();
  workspace_.reserve(*influence_);
  for (core::LaneBuffer* field : {&p_, &gap_, &g_, &t_, &q_})
  {
    field->resize(size_);
    std::fill_n(field->data(), size_, 0.0);
  }
  std::fill_n(gap_.data(), size_, no_surface);
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.rows(); ++i)
    {
      gap_[influence_->rowOffset(i) + influence_->columnOffset(j)] = patch.gap(i, j);
    }
  }
  least_gap_ = patch.gap.minCoeff();
  products_ = 0;
  last_norm_ = 0;
}

/// Initial pressure: proportional to √(mean gap − gap) where the gap is below its mean, otherwise zero.
void PolonskyKeer::start(double load)
{
  double mean = 0;
  int cells = 0;
  for (int k = 0; k < size_; ++k)
  {
    mean += gap_[k] < no_surface ? gap_[k] - least_gap_ : 0;
    cells += gap_[k] < no_surface ? 1 : 0;
  }
  const double level = least_gap_ + mean / cells;
  for (int k = 0; k < size_; ++k)
  {
    p_[k] = std::sqrt(std::max(level - gap_[k], 0.0));
  }
  scaleTo(load);
}

void PolonskyKeer::scaleTo(double load)
{
  double sum = 0;
  for (int k = 0; k < size_; ++k)
  {
    sum += p_[k];
  }
  const double scale = load / sum;
  for (int k = 0; k < size_; ++k)
  {
    p_[k] *= scale;
  }
}

/// Subtracts from a field its mean over the contact. @return this mean
double PolonskyKeer::shiftToContact(core::LaneBuffer& field) const
{
  double sum = 0, cells = 0;
  for (int k = 0; k < size_; ++k)
  {
    sum += p_[k] > 0 ? field[k] : 0;
    cells += p_[k] > 0 ? 1 : 0;
  }
  const double mean = sum / cells;
  for (int k = 0; k < size_; ++k)
  {
    field[k] -= mean;
  }
  return mean;
}

/// Computes deformed gap and approach for the current pressure. @return the residual
double PolonskyKeer::measure()
{
  influence_->multiply(p_.data(), g_.data(), workspace_);
  ++products_;
  for (int k = 0; k < size_; ++k)
  {
    g_[k] += gap_[k];
  }
  approach_ = shiftToContact(g_);
  double worst = 0;
  for (int k = 0; k < size_; ++k)
  {
    worst = std::max(worst, p_[k] > 0 ? std::abs(g_[k]) : -g_[k]);
  }
  return worst / (approach_ - least_gap_);
}

/// One step along the conjugate direction. Cells without pressure that overlap are added to the contact.
/// @return false if the step length is not positive
bool PolonskyKeer::step()
{
  double norm = 0;
  for (int k = 0; k < size_; ++k)
  {
    norm += p_[k] > 0 ? g_[k] * g_[k] : 0;
  }
  const double beta = last_norm_ > 0 ? norm / last_norm_ : 0;
  last_norm_ = norm;
  for (int k = 0; k < size_; ++k)
  {
    t_[k] = p_[k] > 0 ? g_[k] + beta * t_[k] : 0;
  }
  influence_->multiply(t_.data(), q_.data(), workspace_);
  ++products_;
  shiftToContact(q_);
  double along = 0, curvature = 0;
  for (int k = 0; k < size_; ++k)
  {
    along += p_[k] > 0 ? g_[k] * t_[k] : 0;
    curvature += p_[k] > 0 ? q_[k] * t_[k] : 0;
  }
  const double length = along / curvature;
  bool overlap = false;
  for (int k = 0; k < size_; ++k)
  {
    const double moved = std::max(p_[k] - length * t_[k], 0.0);
    const bool pressed = moved == 0 && g_[k] < 0;
    overlap = overlap || pressed;
    p_[k] = pressed ? -length * g_[k] : moved;
  }
  last_norm_ = overlap ? 0 : last_norm_;
  return length > 0;
}

bool PolonskyKeer::solve(const core::NormalProblem& problem)
{
  begin(problem);
  const core::Grid& grid = problem.patches[0].grid;
  // Pressures are expressed as lengths p dy / (pi E*), as in InfluenceOperator.
  const double load = problem.value / (std::acos(-1.0) * problem.modulus / grid.dy * grid.cellArea());
  start(load);
  for (int k = 0; k < most_iterations; ++k)
  {
    if (measure() <= residual_)
    {
      return true;
    }
    if (!step())
    {
      return false;
    }
    scaleTo(load);
  }
  return false;
}
}  // namespace wheel_rail_contact
