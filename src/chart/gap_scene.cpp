// SPDX-License-Identifier: BSD-3-Clause
#include "chart/gap_scene.h"

#include <algorithm>

#include "core/normal/operator/cell_aspect.h"
#include "core/normal/solvers/conjugate_gradients.h"

namespace wheel_rail_contact::core::chart
{
namespace
{
constexpr double margin = 1.04;           ///< size of the grid over that of the overlap, at all positions [-]
constexpr double true_residual = 1e-6;    ///< residual of the reference solution [-]
constexpr GridSize boxing_grid{32, 128};  ///< grid on which the box is determined
constexpr int boxings = 3;

Grid covering(const Box& box, const GridSize& size)
{
  const double width = box.y_end - box.y_begin;
  const double covered = margin * width + 2 * longest_reach * step;
  const cell_aspect::Cell cell = cell_aspect::coveringCell(margin * box.length, covered, size.along, size.across);
  const double first = 0.5 * (box.y_begin + box.y_end - (size.across - 1) * cell.dy);
  return {size.along, size.across, cell.dx, cell.dy, first, true};
}

NormalSolution solveStrictly(const NormalProblem& problem)
{
  ConjugateGradientsOptions options;
  options.residual = true_residual;
  options.max_products = 1000;
  NormalSolution solution;
  ConjugateGradients(options).solve(problem, false, solution);
  return solution;
}

/// Patches of a solution that carry pressure. Without `errors` their estimates are zero.
std::vector<PatchOutcome> patchesOf(const GapScene& scene, const NormalSolution& solution,
                                    const std::vector<ErrorEstimate>& errors)
{
  std::vector<PatchOutcome> patches;
  for (std::size_t k = 0; k < solution.patches.size(); ++k)
  {
    const PatchPressure& pressure = solution.patches[k];
    const GapPatch& patch = scene.patches()[k];
    if (pressure.force > 0)
    {
      patches.push_back({pressure.force, pressure.max_pressure, pressure.area,
                         patch.weight * solution.approach - patch.first_touch,
                         errors.empty() ? ErrorEstimate() : errors[k]});
    }
  }
  return patches;
}

Outcome gapOutcome(const GapScene& scene, const NormalProblem& problem, const NormalSolution& solution,
                   const std::vector<ErrorEstimate>& errors)
{
  Outcome outcome;
  outcome.usable = isUsable(solution.status);
  outcome.reason = outcome.usable ? "" : toString(solution.status);
  if (outcome.usable)
  {
    outcome.grid = {problem.patches.front().grid.nx, problem.patches.front().grid.ny};
    outcome.add(0, patchesOf(scene, solution, errors));
  }
  return outcome;
}

/// Solves like one wheel of the whole calculation: on the first grid, and on finer ones while the estimated error
/// exceeds the tolerance. Each grid starts from its own last solution.
class GapRun : public MethodRun
{
 public:
  GapRun(const GapScene& scene, const GridLevels& levels)
      : scene_(scene), levels_(levels), solutions_(levels.count()), prepared_(levels.count())
  {
    for (std::size_t level = 0; level < levels.count(); ++level)
    {
      for (int offset = -longest_reach; offset <= longest_reach; ++offset)
      {
        prepared_[level].push_back(scene.problem(levels.at(level), offset));
      }
    }
  }

  void solve(double offset) override
  {
    std::size_t level = 0, next = 0;
    do
    {
      level = next;
      solveOn(level, static_cast<int>(offset));
      next = isUsable(solutions_[level].status) ? levels_.finer(level, estimate_) : level;
    } while (next != level);
  }

  void reset() override
  {
    for (NormalSolution& solution : solutions_)
    {
      solution.status = SolveStatus::invalid_problem;
    }
  }

  Outcome outcome() const override { return gapOutcome(scene_, *problem_, solutions_[level_], errors_); }

 private:
  void solveOn(std::size_t level, int offset)
  {
    level_ = level;
    problem_ = &prepared_[level][static_cast<std::size_t>(offset + longest_reach)];
    NormalSolution& solution = solutions_[level];
    const bool warm = isUsable(solution.status);
    levels_.solver().solve(*problem_, warm, solution);
    if (warm && !isUsable(solution.status))
    {
      levels_.solver().solve(*problem_, false, solution);
    }
    errors_.clear();
    estimate_ = 0;
    if (isUsable(solution.status))
    {
      levels_.solver().estimateErrors(*problem_, solution, errors_);
      estimate_ = combined(0, patchesOf(scene_, solution, errors_)).estimate;
    }
  }

  const GapScene& scene_;
  const GridLevels& levels_;
  std::vector<NormalSolution> solutions_;             ///< last one on each grid
  std::vector<std::vector<NormalProblem>> prepared_;  ///< on each grid, at each offset
  std::size_t level_ = 0;                             ///< of the last solution
  const NormalProblem* problem_ = nullptr;
  std::vector<ErrorEstimate> errors_;  ///< one for each patch
  double estimate_ = 0;                ///< of the wheel
};

/// Smallest region that contains the overlap of the undeformed bodies under an approach.
Box overlapBox(const PatchGap& patch, double approach)
{
  const Grid& grid = patch.grid;
  Box box{0, grid.y(grid.ny - 1), grid.y(0)};
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.rows(); ++i)
    {
      if (patch.gap(i, j) < patch.weight * approach)
      {
        box.length = std::max(box.length, 2 * grid.x(i) + grid.dx);
        box.y_begin = std::min(box.y_begin, grid.y(j) - 0.5 * grid.dy);
        box.y_end = std::max(box.y_end, grid.y(j) + 0.5 * grid.dy);
      }
    }
  }
  return box;
}
}  // namespace

GapScene::GapScene(std::string name, std::string title, std::shared_ptr<SolverCache> solver_cache,
                   std::vector<GapPatch> patches, double load)
    : Scene(std::move(name), std::move(title)),
      solvers_(std::move(solver_cache)),
      patches_(std::move(patches)),
      load_(load)
{
  for (int i = 0; i < boxings; ++i)
  {
    tighten();
  }
}

/// Lays the boxes around the overlap that is found in them.
void GapScene::tighten()
{
  const NormalProblem wide = problem(boxing_grid, 0);
  const NormalSolution solution = solveStrictly(wide);
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    patches_[k].box = overlapBox(wide.patches[k], solution.approach);
  }
}

NormalProblem GapScene::problem(const GridSize& size, int offset) const
{
  NormalProblem problem;
  problem.modulus = contactModulus(Material(), Material());
  problem.value = load_;
  for (const GapPatch& patch : patches_)
  {
    PatchGap sampled;
    sampled.grid = covering(patch.box, size);
    sampled.weight = patch.weight;
    sampled.gap.resize(sampled.grid.rows(), sampled.grid.ny);
    for (int j = 0; j < sampled.grid.ny; ++j)
    {
      for (int i = 0; i < sampled.grid.rows(); ++i)
      {
        sampled.gap(i, j) = patch.gap(sampled.grid.x(i), sampled.grid.y(j) - offset * step);
      }
    }
    problem.patches.push_back(std::move(sampled));
  }
  return problem;
}

Outcome GapScene::truth(const GridSize& grid, int offset)
{
  const NormalProblem fine = problem(grid, offset);
  return gapOutcome(*this, fine, solveStrictly(fine), {});
}

std::unique_ptr<MethodRun> GapScene::makeRun(const Choice& choice)
{
  return std::make_unique<GapRun>(*this, solvers_->find(choice));
}
}  // namespace wheel_rail_contact::core::chart
