// SPDX-License-Identifier: BSD-3-Clause
#include "chart/gap_scene.h"

#include <algorithm>

#include "core/balance/pressure_extent.h"
#include "core/normal/operator/cell_aspect.h"
#include "core/normal/solvers/conjugate_gradients.h"

namespace wheel_rail_contact::core::chart
{
namespace
{
constexpr double margin = 1.1;  ///< size of the grid over that of the pressure, as in the balance, at all positions [-]
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

Outcome gapOutcome(const GapScene& scene, const NormalProblem& problem, const NormalSolution& solution)
{
  Outcome outcome;
  outcome.usable = isUsable(solution.status);
  outcome.reason = outcome.usable ? "" : toString(solution.status);
  for (std::size_t k = 0; outcome.usable && k < problem.patches.size(); ++k)
  {
    const Grid& grid = problem.patches[k].grid;
    const PatchPressure& pressure = solution.patches[k];
    outcome.grid = {grid.nx, grid.ny};
    if (pressure.force > 0)
    {
      const GapPatch& patch = scene.patches()[k];
      outcome.patches.push_back(
          {0, pressure.max_pressure, pressure.area, patch.weight * solution.approach - patch.first_touch});
    }
  }
  return outcome;
}

/// Solves like one wheel of the whole calculation. From a cold start, a rough solution chooses method and grid. Each
/// result has an error estimate, by which the grid is kept, refined or coarsened.
class GapRun : public MethodRun
{
 public:
  GapRun(const GapScene& scene, const GridLevels& levels, double tolerance)
      : scene_(scene), levels_(levels), tolerance_(tolerance), choice_(levels, tolerance)
  {
    for (std::size_t level = 0; level < levels.count(); ++level)
    {
      prepare(scene, levels.at(level).size);
    }
    if (levels.closedForm() != nullptr)
    {
      prepare(scene, levels.closedForm()->size);
    }
  }

  void solve(int offset) override
  {
    choice_.arrive(offset * step);
    if (!warm_ && levels_.count() > 1)
    {
      solveOn(levels_.rough(), offset);
      choice_.start(estimate_);
      choice_.tryClosedForm(*problem_, solution_);
    }
    do
    {
      solveOn(choice_.level(), offset);
    } while (warm_ ? choice_.refine(estimate_) : choice_.leaveClosedForm());
    choice_.coarsen(estimate_);
    choice_.tryClosedForm(*problem_, solution_);
  }

  void reset() override
  {
    warm_ = false;
    choice_ = GridLevelChoice(levels_, tolerance_);
  }

  Outcome outcome() const override
  {
    Outcome outcome = gapOutcome(scene_, *problem_, solution_);
    outcome.estimate = estimate_.largest();
    outcome.solver = solver_->name();
    return outcome;
  }

 private:
  struct Prepared
  {
    GridSize size;
    int offset;
    NormalProblem problem;
  };

  void prepare(const GapScene& scene, const GridSize& size)
  {
    for (int offset = -longest_reach; offset <= longest_reach; ++offset)
    {
      prepared_.push_back({size, offset, scene.problem(size, offset)});
    }
  }

  void solveOn(const GridLevel& level, int offset)
  {
    const GridSize& size = level.size;
    problem_ = &std::find_if(prepared_.begin(), prepared_.end(),
                             [&](const Prepared& p) { return p.size == size && p.offset == offset; })
                    ->problem;
    solver_ = level.solver;
    solver_->solve(*problem_, warm_, solution_);
    if (warm_ && !isUsable(solution_.status))
    {
      solver_->solve(*problem_, false, solution_);
    }
    warm_ = isUsable(solution_.status);
    errors_.clear();
    if (warm_)
    {
      solver_->estimateErrors(*problem_, solution_, errors_);
    }
    estimate_ = largestOf(errors_);
  }

  const GapScene& scene_;
  const GridLevels& levels_;
  double tolerance_;
  GridLevelChoice choice_;
  std::vector<Prepared> prepared_;
  NormalSolver* solver_ = nullptr;  ///< solver of the last solution
  const NormalProblem* problem_ = nullptr;
  NormalSolution solution_;
  std::vector<ErrorEstimate> errors_;  ///< one for each patch
  ErrorEstimate estimate_;             ///< largest of them
  bool warm_ = false;
};
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

/// Lays the boxes around the pressure that is found in them.
void GapScene::tighten()
{
  const NormalProblem wide = problem(boxing_grid, 0);
  const NormalSolution solution = solveStrictly(wide);
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const PressureExtent extent = findExtent(wide.patches[k].grid, solution.patches[k].pressure);
    patches_[k].box = {2 * extent.half_length, extent.y_begin, extent.y_end};
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
  return gapOutcome(*this, fine, solveStrictly(fine));
}

std::unique_ptr<MethodRun> GapScene::makeRun(const Choice& choice)
{
  return std::make_unique<GapRun>(*this, solvers_->find(choice), contactConfig(choice).tolerance);
}
}  // namespace wheel_rail_contact::core::chart
