// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/contact_tangent.h"

#include <algorithm>
#include <limits>

namespace wheel_rail_contact::core
{
namespace
{
constexpr int most_steps = 200;
}  // namespace

double ContactTangent::dot(const LaneBuffer& a, const LaneBuffer& b) const
{
  double sum = 0;
  for (const PatchLayout& patch : patches_)
  {
    sum += patch.force * kernels_.dot(patch.size, a.data() + patch.begin, b.data() + patch.begin);
  }
  return sum;
}

void ContactTangent::precondition()
{
  for (const PatchLayout& patch : patches_)
  {
    columns_.precondition(patch, r_, z_, workspace_);
  }
  mask(z_);
}

/// Solves A_cc x = right by preconditioned conjugate gradients (Hestenes & Stiefel 1952).
void ContactTangent::solve(const LaneBuffer& right)
{
  std::fill_n(x_.data(), length_, 0.0);
  std::copy_n(right.data(), length_, r_.data());
  const double enough = residual_ * largest(right);
  precondition();
  std::copy_n(z_.data(), length_, s_.data());
  double r_z = dot(r_, z_);
  for (int step = 0; step < most_steps && largest(r_) > enough; ++step)
  {
    columns_.multiply(patches_, s_, q_, workspace_);
    ++products_;
    mask(q_);
    const double curvature = dot(s_, q_);
    if (!(curvature > 0))
    {
      break;
    }
    const double length = r_z / curvature;
    kernels_.add(length_, length, s_.data(), x_.data());
    kernels_.add(length_, -length, q_.data(), r_.data());
    precondition();
    const double next = dot(r_, z_);
    kernels_.scale(length_, next / r_z, s_.data());
    kernels_.add(length_, 1, z_.data(), s_.data());
    r_z = next;
  }
  if (!(largest(r_) <= enough))
  {
    std::fill_n(x_.data(), length_, std::numeric_limits<double>::quiet_NaN());
  }
}

/// Sets all fields but those of the openings.
void ContactTangent::layOutLoaded(const CurvedProblem& problem, const NormalSolution& solution)
{
  length_ = layOut(problem, &cache_, patches_);
  for (LaneBuffer* field : {&gap_, &loaded_, &x_, &r_, &z_, &s_, &q_})
  {
    field->resize(length_);
    std::fill_n(field->data(), length_, 0.0);
  }
  columns_.begin(&problem, patches_, length_, gap_);
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    workspace_.reserve(*patches_[k].influence);
    toField(patches_[k], 1, solution.patches[k].pressure, loaded_);
  }
  std::transform(loaded_.data(), loaded_.data() + length_, loaded_.data(), [](double p) { return p > 0 ? 1.0 : 0.0; });
}

/// Sets all fields.
void ContactTangent::begin(const CurvedProblem& problem, const NormalSolution& solution,
                           const std::vector<Eigen::ArrayXXd>& openings)
{
  layOutLoaded(problem, solution);
  openings_.resize(static_cast<std::size_t>(openings.front().cols()));
  for (std::size_t m = 0; m < openings_.size(); ++m)
  {
    LaneBuffer& field = openings_[m];
    field.resize(length_);
    std::fill_n(field.data(), length_, 0.0);
    for (std::size_t k = 0; k < patches_.size(); ++k)
    {
      columnsToField(patches_[k], openings[k].col(static_cast<Eigen::Index>(m)), field);
    }
    columns_.scaleOpening(field);
    mask(field);
  }
}

void ContactTangent::pressures(const CurvedProblem& problem, const NormalSolution& solution,
                               const std::vector<std::vector<Eigen::ArrayXXd>>& openings,
                               std::vector<std::vector<Eigen::ArrayXXd>>& changes)
{
  layOutLoaded(problem, solution);
  openings_.resize(1);
  openings_[0].resize(length_);
  changes.resize(openings.size());
  for (std::size_t m = 0; m < openings.size(); ++m)
  {
    std::fill_n(openings_[0].data(), length_, 0.0);
    changes[m].resize(patches_.size());
    for (std::size_t k = 0; k < patches_.size(); ++k)
    {
      toField(patches_[k], 1, openings[m][k], openings_[0]);
    }
    columns_.scaleOpening(openings_[0]);
    mask(openings_[0]);
    solve(openings_[0]);
    columns_.scaleOpening(x_);
    for (std::size_t k = 0; k < patches_.size(); ++k)
    {
      fromField(patches_[k], -patches_[k].stiffness, x_, changes[m][k]);
    }
  }
}

ContactTangent::Forces ContactTangent::column(Eigen::Index displacement)
{
  Forces forces = Forces::Zero(static_cast<Eigen::Index>(openings_.size()));
  if (largest(loaded_) > 0)
  {
    solve(openings_[static_cast<std::size_t>(displacement)]);
    for (Eigen::Index n = 0; n < forces.size(); ++n)
    {
      forces[n] = dot(openings_[static_cast<std::size_t>(n)], x_);
    }
  }
  return forces;
}

ContactTangent::Stiffness ContactTangent::stiffness(const CurvedProblem& problem, const NormalSolution& solution,
                                                    const std::vector<Eigen::ArrayXXd>& openings)
{
  begin(problem, solution, openings);
  const auto count = static_cast<Eigen::Index>(openings_.size());
  Stiffness stiffness(count, count);
  for (Eigen::Index m = 0; m < count; ++m)
  {
    stiffness.col(m) = column(m);
  }
  return 0.5 * (stiffness + stiffness.transpose());
}

ContactTangent::Forces ContactTangent::stiffness(const CurvedProblem& problem, const NormalSolution& solution,
                                                 const std::vector<Eigen::ArrayXXd>& openings,
                                                 Eigen::Index displacement)
{
  begin(problem, solution, openings);
  return column(displacement);
}
}  // namespace wheel_rail_contact::core
