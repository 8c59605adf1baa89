// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/column_fields.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
namespace
{
/// Sets a field to a value in each column, and to 1 in the padding.
template <typename Value>
void fill(const NormalProblem& problem, const std::vector<PatchLayout>& patches, int length, Value value,
          LaneBuffer& field)
{
  field.resize(length);
  std::fill_n(field.data(), length, 1.0);
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    columnsToField(patches[k], value(problem.patches[k]), field);
  }
}

Eigen::ArrayXd weightOf(const PatchGap& patch)
{
  return patch.column_weight.size() > 0 ? patch.column_weight : Eigen::ArrayXd::Ones(patch.grid.ny);
}

Eigen::ArrayXd turnOf(const PatchGap& patch)
{
  return patch.turn.size() > 0 ? patch.turn : Eigen::ArrayXd::Zero(patch.grid.ny);
}
}  // namespace

void ColumnFields::begin(const NormalProblem& problem, std::vector<PatchLayout>& patches, int length, LaneBuffer& gap)
{
  const auto any = [&problem](const auto& property)
  { return std::any_of(problem.patches.begin(), problem.patches.end(), property); };
  scaled_ = any([](const PatchGap& patch) { return patch.column_weight.size() > 0; });
  turned_ = any([](const PatchGap& patch) { return patch.turn.size() > 0; });
  length_ = length;
  if (!scaled_ && !turned_)
  {
    return;
  }
  work_.resize(length);
  fill(problem, patches, length, weightOf, weight_);
  fill(
      problem, patches, length, [](const PatchGap& patch) { return Eigen::ArrayXd(1 / weightOf(patch)); }, per_weight_);
  if (turned_)
  {
    product_.resize(length);
    fill(
        problem, patches, length,
        [](const PatchGap& patch) { return Eigen::ArrayXd(turnOf(patch).cos() / weightOf(patch)); }, cosine_);
    fill(
        problem, patches, length,
        [](const PatchGap& patch) { return Eigen::ArrayXd(turnOf(patch).sin() / weightOf(patch)); }, sine_);
  }
  if (scaled_)
  {
    kernels_.multiply_by(length, per_weight_.data(), gap.data());
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
      const PatchGap& patch = problem.patches[k];
      patches[k].least_gap = (patch.gap.colwise().minCoeff().transpose() / weightOf(patch)).minCoeff();
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
    return;
  }
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
