// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/estimate/islands.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Appends the islands of a patch, without the columns that belong to them.
void addIslands(std::size_t patch, const Eigen::ArrayXXd& pressure, std::vector<Island>& islands)
{
  bool inside = false;
  for (Eigen::Index j = 0; j < pressure.cols(); ++j)
  {
    const bool loaded = pressure.col(j).maxCoeff() > 0;
    if (loaded && !inside)
    {
      islands.push_back({patch, j, j, 0, 0});
    }
    if (loaded)
    {
      islands.back().last = j;
    }
    inside = loaded;
  }
}
}  // namespace

void Islands::find(const CurvedProblem& problem, const NormalSolution& solution)
{
  whole_problem_ = &problem;
  whole_solution_ = &solution;
  islands_.clear();
  separate_ = false;
  for (std::size_t k = 0; k < solution.patches.size(); ++k)
  {
    const std::size_t first = islands_.size();
    const Eigen::ArrayXXd& pressure = solution.patches[k].pressure;
    addIslands(k, pressure, islands_);
    separate_ = separate_ || islands_.size() != first + 1;
    for (std::size_t i = first; i < islands_.size(); ++i)
    {
      Island& island = islands_[i];
      island.begin = i > first ? islands_[i - 1].begin + islands_[i - 1].columns : 0;
      const Eigen::Index end =
          i + 1 < islands_.size() ? (island.last + islands_[i + 1].first + 1) / 2 : pressure.cols();
      island.columns = end - island.begin;
    }
  }
  if (!separate_)
  {
    return;
  }
  problem_.modulus = problem.modulus;
  problem_.control = problem.control;
  problem_.value = problem.value;
  solution_.status = solution.status;
  solution_.approach = solution.approach;
  solution_.iterations = solution.iterations;
  solution_.residual = solution.residual;
  problem_.patches.resize(islands_.size());
  solution_.patches.resize(islands_.size());
  for (std::size_t i = 0; i < islands_.size(); ++i)
  {
    cut(islands_[i], problem_.patches[i], solution_.patches[i]);
  }
}

/// Copies an island from its grid and measures its pressure.
void Islands::cut(const Island& island, PatchGap& gap, PatchPressure& pressure)
{
  const PatchGap& whole_gap = whole_problem_->patches[island.patch];
  const PatchPressure& whole = whole_solution_->patches[island.patch];
  gap.grid = whole_gap.grid;
  gap.grid.ny = static_cast<int>(island.columns);
  gap.grid.y0 = whole_gap.grid.y(static_cast<int>(island.begin));
  gap.gap = whole_gap.gap.middleCols(island.begin, island.columns);
  gap.unseen_slope.resize(0);
  if (whole_gap.unseen_slope.size() > 0)
  {
    gap.unseen_slope = whole_gap.unseen_slope.segment(island.begin, island.columns);
  }
  Eigen::Index row = 0, deepest = 0;
  gap.gap.minCoeff(&row, &deepest);
  const bool weighted = !whole_problem_->normals.empty() && whole_problem_->normals[island.patch].weight.size() > 0;
  gap.weight = whole_gap.weight * (weighted ? whole_problem_->normals[island.patch].weight[island.begin + deepest] : 1);
  pressure.grid = gap.grid;
  pressure.pressure = whole.pressure.middleCols(island.begin, island.columns);
  measures_.measure(gap, whole_problem_->modulus, pressure);
}

void WheelError::add(const ContactMeasures& patch, const ErrorEstimate& error)
{
  const double height = patch.max_pressure / wheel_.max_pressure;
  pressure_ = std::max(pressure_, height - 1 + error.max_pressure * height);
  area_ += error.area * patch.area / wheel_.area;
  approach_ += error.approach * patch.force / wheel_.force;
}
}  // namespace wheel_rail_contact::core
