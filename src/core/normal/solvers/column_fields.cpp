// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/column_fields.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
double weightOf(const ColumnNormals& normals, Eigen::Index column)
{
  return normals.weight.size() > 0 ? normals.weight[column] : 1;
}

double turnOf(const ColumnNormals& normals, Eigen::Index column)
{
  return normals.turn.size() > 0 ? normals.turn[column] : 0;
}
}  // namespace

void ColumnFields::begin(const CurvedProblem* problem, std::vector<PatchLayout>& patches, int length, LaneBuffer& gap)
{
  const auto any = [problem](const auto& property)
  { return problem && std::any_of(problem->normals.begin(), problem->normals.end(), property); };
  scaled_ = any([](const ColumnNormals& normals) { return normals.weight.size() > 0; });
  turned_ = any([](const ColumnNormals& normals) { return normals.areTurned(); });
  coupled_ = problem && problem->isCoupled();
  coupling_ = coupled_ ? &problem->coupling : nullptr;
  length_ = length;
  if (!scaled_ && !turned_ && !coupled_)
  {
    return;
  }
  work_.resize(length);
  const auto fill = [&](auto value, LaneBuffer& field)
  {
    field.resize(length);
    std::fill_n(field.data(), length, 1.0);  // the padding, too
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
      values_.resize(patches[k].grid.ny);
      for (Eigen::Index j = 0; j < values_.size(); ++j)
      {
        values_[j] = value(problem->normals[k], j);
      }
      columnsToField(patches[k], values_, field);
    }
  };
  if (turned_)
  {
    product_.resize(length);
    fill([](const ColumnNormals& normals, Eigen::Index j)
         { return std::cos(turnOf(normals, j)) / weightOf(normals, j); },
         cosine_);
    fill([](const ColumnNormals& normals, Eigen::Index j)
         { return std::sin(turnOf(normals, j)) / weightOf(normals, j); },
         sine_);
  }
  if (scaled_)
  {
    fill(weightOf, weight_);
    per_weight_.resize(length);
    std::transform(weight_.data(), weight_.data() + length, per_weight_.data(),
                   [](double weight) { return 1 / weight; });
    kernels_.multiply_by(length, per_weight_.data(), gap.data());
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
      const PatchGap& patch = problem->patches[k];
      double& least = patches[k].least_gap = infinity;
      for (Eigen::Index j = 0; j < patch.grid.ny; ++j)
      {
        least = std::min(least, patch.gap.col(j).minCoeff() / weightOf(problem->normals[k], j));
      }
    }
  }
}

void ColumnFields::scale(LaneBuffer& pressure, LaneBuffer& displacement) const
{
  if (scaled_)
  {
    kernels_.multiply_by(length_, weight_.data(), pressure.data());
    kernels_.multiply_by(length_, per_weight_.data(), displacement.data());
  }
}

void ColumnFields::unscale(LaneBuffer& pressure, LaneBuffer& displacement) const
{
  if (scaled_)
  {
    kernels_.multiply_by(length_, per_weight_.data(), pressure.data());
    kernels_.multiply_by(length_, weight_.data(), displacement.data());
  }
}

void ColumnFields::scaleOpening(LaneBuffer& opening) const
{
  if (scaled_)
  {
    kernels_.multiply_by(length_, per_weight_.data(), opening.data());
  }
}

void ColumnFields::multiply(const std::vector<PatchLayout>& patches, const LaneBuffer& in, LaneBuffer& out,
                            InfluenceOperator::Workspace& workspace)
{
  if (turned_)
  {
    multiplyTurned(patches, in, out, workspace);
  }
  else
  {
    const LaneBuffer* values = &in;
    if (scaled_)
    {
      std::copy_n(in.data(), length_, work_.data());
      kernels_.multiply_by(length_, per_weight_.data(), work_.data());
      values = &work_;
    }
    for (const PatchLayout& patch : patches)
    {
      patch.influence->multiply(values->data() + patch.begin, out.data() + patch.begin, workspace);
    }
    scaleOpening(out);
  }
  if (coupled_)
  {
    addCoupling(patches, in, out);
  }
}

/// Adds the displacements of the columns by the forces in the columns of other patches.
void ColumnFields::addCoupling(const std::vector<PatchLayout>& patches, const LaneBuffer& in, LaneBuffer& out)
{
  std::copy_n(in.data(), length_, work_.data());
  scaleOpening(work_);
  column_force_.resize(coupling_->rows());
  column_displacement_.resize(coupling_->rows());
  Eigen::Index first = 0;
  for (const PatchLayout& patch : patches)
  {
    columnSums(patch, work_, column_force_.segment(first, patch.grid.ny));
    column_force_.segment(first, patch.grid.ny) *= patch.force;
    first += patch.grid.ny;
  }
  column_displacement_.noalias() = *coupling_ * column_force_;
  first = 0;
  for (const PatchLayout& patch : patches)
  {
    columnsToField(patch, column_displacement_.segment(first, patch.grid.ny).array(), work_);
    first += patch.grid.ny;
  }
  scaleOpening(work_);
  kernels_.add(length_, 1, work_.data(), out.data());
}

void ColumnFields::multiplyTurned(const std::vector<PatchLayout>& patches, const LaneBuffer& in, LaneBuffer& out,
                                  InfluenceOperator::Workspace& workspace)
{
  std::fill_n(out.data(), length_, 0.0);
  for (const LaneBuffer* share : {&cosine_, &sine_})
  {
    std::copy_n(in.data(), length_, work_.data());
    kernels_.multiply_by(length_, share->data(), work_.data());
    for (const PatchLayout& patch : patches)
    {
      patch.influence->multiply(work_.data() + patch.begin, product_.data() + patch.begin, workspace);
    }
    kernels_.multiply_by(length_, share->data(), product_.data());
    kernels_.add(length_, 1, product_.data(), out.data());
  }
}

void ColumnFields::precondition(const PatchLayout& patch, const LaneBuffer& in, LaneBuffer& out,
                                InfluenceOperator::Workspace& workspace)
{
  const double* values = in.data() + patch.begin;
  if (scaled_)
  {
    double* const scaled = work_.data() + patch.begin;
    std::copy_n(values, patch.size, scaled);
    kernels_.multiply_by(patch.size, weight_.data() + patch.begin, scaled);
    values = scaled;
  }
  patch.influence->precondition(values, out.data() + patch.begin, workspace);
  if (scaled_)
  {
    kernels_.multiply_by(patch.size, weight_.data() + patch.begin, out.data() + patch.begin);
  }
}
}  // namespace wheel_rail_contact::core
