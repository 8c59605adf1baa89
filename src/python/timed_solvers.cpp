// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/balance/grid_levels.h"
#include "core/normal/operator/operator_cache.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/hertz.h"
#include "python/timed_run.h"
#include "wheel_rail_contact/core/creep.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
constexpr double reference_residual = 1e-6;  ///< residual of the reference solution [-]

/// Contact of steel bodies, given by the gaps of its patches. Each patch is symmetric along the track.
struct GapProblem
{
  core::NormalProblem problem;
  std::vector<double> first_touch;  ///< least gap of each patch [m]

  /// @param load  [N]
  explicit GapProblem(double load)
  {
    problem.modulus = contactModulus(core::Material(), core::Material());
    problem.value = load;
  }

  /// Adds a patch whose grid has the centres of its first column at y0 [m]; `gap` has the half x > 0.
  void add(const core::cell_aspect::Cell& cell, double y0, const Eigen::ArrayXXd& gap, double weight, double touch)
  {
    core::PatchGap& patch = problem.patches.emplace_back();
    patch.grid = {static_cast<int>(2 * gap.rows()), static_cast<int>(gap.cols()), cell.dx, cell.dy, y0, true};
    patch.gap = gap;
    patch.weight = weight;
    first_touch.push_back(touch);
  }
};

/// Patches of a solution that carry pressure. Without `errors` their estimates are zero.
std::vector<PatchOutcome> patchesOf(const GapProblem& gaps, const core::NormalSolution& solution,
                                    const std::vector<core::ErrorEstimate>& errors)
{
  std::vector<PatchOutcome> patches;
  for (std::size_t k = 0; k < solution.patches.size(); ++k)
  {
    const core::PatchPressure& pressure = solution.patches[k];
    if (pressure.force > 0)
    {
      patches.push_back({{pressure.max_pressure, pressure.area, pressure.force},
                         gaps.problem.patches[k].weight * solution.approach - gaps.first_touch[k],
                         errors.empty() ? core::ErrorEstimate() : errors[k]});
    }
  }
  return patches;
}

Outcome gapOutcome(const GapProblem& gaps, const core::NormalSolution& solution,
                   const std::vector<core::ErrorEstimate>& errors)
{
  Outcome outcome;
  outcome.usable = isUsable(solution.status);
  outcome.reason = outcome.usable ? "" : toString(solution.status);
  if (outcome.usable)
  {
    outcome.grid = {gaps.problem.patches.front().grid.nx, gaps.problem.patches.front().grid.ny};
    outcome.add(0, patchesOf(gaps, solution, errors));
  }
  return outcome;
}

/// Solves like one wheel of the whole calculation: on the first grid, and on finer ones while the estimated error
/// exceeds the tolerance. Each grid starts from its own last solution.
class GapRun : public TimedRun
{
 public:
  /// @param problems  on each grid of the levels, in each state
  GapRun(std::shared_ptr<core::GridLevels> levels, std::vector<std::vector<GapProblem>> problems)
      : levels_(std::move(levels)), problems_(std::move(problems)), solutions_(levels_->count())
  {
  }

  void solve(std::size_t state) override
  {
    std::size_t level = 0, next = 0;
    do
    {
      level = next;
      solveOn(level, state);
      next = isUsable(solutions_[level].status) ? levels_->finer(level, estimate_) : level;
    } while (next != level);
  }

  void reset() override
  {
    for (core::NormalSolution& solution : solutions_)
    {
      solution.status = core::SolveStatus::invalid_problem;
    }
  }

  Outcome outcome() const override { return gapOutcome(*gaps_, solutions_[level_], errors_); }

 private:
  void solveOn(std::size_t level, std::size_t state)
  {
    level_ = level;
    gaps_ = &problems_.at(level).at(state);
    core::NormalSolution& solution = solutions_[level];
    const bool warm = isUsable(solution.status);
    levels_->solver().solve(gaps_->problem, warm, solution);
    if (warm && !isUsable(solution.status))
    {
      levels_->solver().solve(gaps_->problem, false, solution);
    }
    errors_.clear();
    estimate_ = 0;
    if (isUsable(solution.status))
    {
      levels_->solver().estimateErrors(gaps_->problem, solution, errors_);
      estimate_ = combined(0, patchesOf(*gaps_, solution, errors_)).estimate;
    }
  }

  std::shared_ptr<core::GridLevels> levels_;
  std::vector<std::vector<GapProblem>> problems_;
  std::vector<core::NormalSolution> solutions_;  ///< last one on each grid
  std::size_t level_ = 0;                        ///< of the last solution
  const GapProblem* gaps_ = nullptr;             ///< of the last solution
  std::vector<core::ErrorEstimate> errors_;      ///< one for each patch
  double estimate_ = 0;                          ///< of the wheel
};

/// Reference solution: its common approach [m], and its outcome.
std::pair<double, Outcome> gapReference(const GapProblem& gaps)
{
  core::ConjugateGradientsOptions options;
  options.residual = reference_residual;
  options.max_products = 1000;
  core::NormalSolution solution;
  core::ConjugateGradients(options).solve(gaps.problem, false, solution);
  return {solution.approach, gapOutcome(gaps, solution, {})};
}

/// @param grid  of a method other than `auto`
/// @param tolerance  [-]; 0: the default
std::shared_ptr<core::GridLevels> levelsOf(const std::string& method, const std::pair<int, int>& grid, double tolerance)
{
  core::ContactModelConfig config;
  config.contact.method = core::methodNamed(method);
  config.contact.cells_along = grid.first;
  config.contact.cells_across = grid.second;
  config.contact.tolerance = tolerance > 0 ? tolerance : config.contact.tolerance;
  return std::make_shared<core::GridLevels>(config);
}

/// Cells along and across of each grid.
std::vector<std::pair<int, int>> gridsOf(const core::GridLevels& levels)
{
  std::vector<std::pair<int, int>> grids;
  for (std::size_t level = 0; level < levels.count(); ++level)
  {
    grids.emplace_back(levels.at(level).along, levels.at(level).across);
  }
  return grids;
}

/// A creep method on an ellipse with the pressure of Hertz. Its states are creepages. Every solution starts cold; the
/// tables of the grid are kept.
class CreepRun : public TimedRun
{
 public:
  /// @param creepages  x, y [-] and spin [1/m] of each state
  CreepRun(const std::string& method, const std::array<double, 3>& semi_axes_and_force, const std::array<int, 2>& cells,
           const std::vector<std::array<double, 3>>& creepages)
      : solver_(makeCreepSolver(core::creepMethodNamed(method)))
  {
    const auto& [a, b, force] = semi_axes_and_force;
    for (const auto& [x, y, spin] : creepages)
    {
      problems_.push_back(core::ellipseProblem({a, b, force, cells[0], cells[1]}, {x, y, spin}));
    }
  }

  void solve(std::size_t state) override
  {
    grid_ = {problems_.at(state).grid.nx, problems_.at(state).grid.ny};
    solver_->solve(problems_[state], false, solution_);
  }
  void reset() override {}

  /// There are no wheels.
  Outcome outcome() const override
  {
    const bool usable = isUsable(solution_.status);
    return {usable, usable ? "" : toString(solution_.status), grid_, solution_.error_estimate, {}};
  }

  /// Fx, Fy [N] and Mz [N m] on the wheel in the last solution.
  std::array<double, 3> force() const { return {solution_.force.x, solution_.force.y, solution_.force.moment}; }

 private:
  std::unique_ptr<core::CreepSolver> solver_;
  std::vector<core::CreepProblem> problems_;
  core::CreepSolution solution_;
  core::GridSize grid_;
};
}  // namespace

void bindTimedSolvers(py::module& module)
{
  using core::cell_aspect::Cell;
  py::class_<core::GridLevels, std::shared_ptr<core::GridLevels>>(module, "GridLevels")
      .def(py::init(&levelsOf))
      .def_property_readonly("grids", &gridsOf);
  py::class_<Cell>(module, "Cell").def_readonly("dx", &Cell::dx).def_readonly("dy", &Cell::dy);
  module.def("covering_cell", &core::cell_aspect::coveringCell);
  py::class_<GapProblem>(module, "GapProblem").def(py::init<double>()).def("add", &GapProblem::add);
  py::class_<GapRun, TimedRun>(module, "GapRun")
      .def(py::init<std::shared_ptr<core::GridLevels>, std::vector<std::vector<GapProblem>>>());
  module.def("gap_reference", &gapReference);
  module.def("hertz_semi_axes",
             [](double a, double b)
             {
               const core::HertzContact contact = core::hertzForApproach({a, b}, 1, 1);
               return std::make_pair(contact.semi_axis_x, contact.semi_axis_y);
             });
  py::class_<CreepRun, TimedRun>(module, "CreepRun")
      .def(py::init<const std::string&, const std::array<double, 3>&, const std::array<int, 2>&,
                    const std::vector<std::array<double, 3>>&>())
      .def("force", &CreepRun::force);
}
}  // namespace wheel_rail_contact
