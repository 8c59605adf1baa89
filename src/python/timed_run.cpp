// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <ros/package.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/balance/grid_levels.h"
#include "core/balance/islands.h"
#include "core/balance/patch_result.h"
#include "core/balance/wheelset_balance.h"
#include "core/normal/operator/operator_cache.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/hertz.h"
#include "python/bindings.h"
#include "python/contact_model.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
/// CPU time of this thread [s].
double threadTime()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// One patch of a wheel.
struct PatchOutcome
{
  core::ContactMeasures measures;
  double approach = 0;  ///< from the first touch of the patch, along its normal [m]
  core::ErrorEstimate error;
};

/// Quantities of one wheel that the chart compares. Two patches close to one another may be one on a coarse grid, so
/// the chart does not compare single patches.
struct WheelOutcome
{
  int index = 0;            ///< of the wheel
  double max_pressure = 0;  ///< highest [Pa]
  double area = 0;          ///< of all patches [m²]
  double approach = 0;      ///< mean of the patches, weighted with their forces [m]
  double estimate = 0;      ///< estimated relative error, largest of the three quantities [-]
};

/// Combines the patches of a wheel. The estimate follows the same rule as that of the balance.
WheelOutcome combined(int index, const std::vector<PatchOutcome>& patches)
{
  core::ContactMeasures all;
  for (const PatchOutcome& patch : patches)
  {
    all.add(patch.measures);
  }
  WheelOutcome wheel{index, all.max_pressure, all.area, 0, 0};
  core::WheelError error(all);
  for (const PatchOutcome& patch : patches)
  {
    wheel.approach += patch.approach * patch.measures.force / all.force;
    error.add(patch.measures, patch.error);
  }
  wheel.estimate = error.largest();
  return wheel;
}

/// Result of one method in one state of a scene.
struct Outcome
{
  bool usable = false;
  std::string reason;                ///< reason of a failure; empty if usable
  core::GridSize grid;               ///< finest of the patches
  double estimate = 0;               ///< estimated relative error, largest of the wheels [-]
  std::vector<WheelOutcome> wheels;  ///< those with a contact

  /// Adds a wheel, if it has patches.
  void add(int index, const std::vector<PatchOutcome>& patches)
  {
    if (!patches.empty())
    {
      wheels.push_back(combined(index, patches));
      estimate = std::max(estimate, wheels.back().estimate);
    }
  }
};

/// A method on the states of a scene. Its times do not contain those of the interpreter.
class TimedRun
{
 public:
  virtual ~TimedRun() = default;

  /// Solves a state, starting from the last result if there is one.
  virtual void solve(std::size_t state) = 0;
  /// The next result starts cold.
  virtual void reset() = 0;
  /// Outcome of the last result.
  virtual Outcome outcome() const = 0;

  /// Solves states in turn. Returns their mean CPU time of this thread, which other processes do not change [s].
  /// @param cold  each of them starts cold
  double time(const std::vector<std::size_t>& states, bool cold)
  {
    const double start = threadTime();
    for (const std::size_t state : states)
    {
      if (cold)
      {
        reset();
      }
      solve(state);
    }
    return (threadTime() - start) / static_cast<double>(states.size());
  }

  /// Solves states in turn. Returns the CPU time of each [s].
  std::vector<double> times(const std::vector<std::size_t>& states)
  {
    std::vector<double> each;
    each.reserve(states.size());
    for (const std::size_t state : states)
    {
      each.push_back(time({state}, false));
    }
    return each;
  }
};

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

/// Adds runs on the gaps of a normal problem.
void bindTimedGaps(py::module& module)
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
}

/// A result has one estimate for each patch, which holds for all of its quantities.
PatchOutcome outcomeOf(const core::PatchResult& patch)
{
  const double error = patch.error_estimate;
  return {{patch.max_pressure, patch.area, patch.normal_force}, patch.approach, {error, error, error}};
}

void addWheels(const std::vector<core::PatchResult>& patches, Outcome& outcome)
{
  for (const core::Side side : core::sides)
  {
    std::vector<PatchOutcome> own;
    for (const core::PatchResult& patch : patches)
    {
      if (patch.side == side)
      {
        const bool finer = patch.grid.nx * patch.grid.ny > outcome.grid.along * outcome.grid.across;
        outcome.grid = finer ? core::GridSize{patch.grid.nx, patch.grid.ny} : outcome.grid;
        own.push_back(outcomeOf(patch));
      }
    }
    outcome.add(static_cast<int>(side), own);
  }
}

/// A wheelset that keeps its solvers from scene to scene: preparing them costs more than many solutions.
using SharedWheelset = std::shared_ptr<core::WheelsetContact>;

core::ContactModelConfig modelOf(const std::vector<ParameterSource>& sources)
{
  return readContactParameters(sources, {".", ros::package::getPath}).model;
}

/// @param y  of the axle centre [m]
/// @param force_z  load on it, up positive [N]
core::WheelsetState stateAt(double y, double force_z)
{
  core::WheelsetState state;
  state.y = y;
  state.force_z = force_z;
  return state;
}

/// Whole calculation. Runs of one wheelset share its last result: only the latest run may be used.
class WheelsetRun : public TimedRun
{
 public:
  WheelsetRun(SharedWheelset wheelset, const std::vector<double>& y, double force_z) : wheelset_(std::move(wheelset))
  {
    for (const double each : y)
    {
      states_.push_back(stateAt(each, force_z));
    }
    wheelset_->reset();
  }

  void solve(std::size_t state) override { result_ = &wheelset_->evaluate(states_.at(state)); }
  void reset() override { wheelset_->reset(); }

  Outcome outcome() const override
  {
    Outcome outcome;
    outcome.usable = isUsable(result_->status);
    outcome.reason = outcome.usable ? "" : result_->reason;
    addWheels(result_->patches, outcome);
    return outcome;
  }

 private:
  SharedWheelset wheelset_;
  std::vector<core::WheelsetState> states_;
  const core::WheelsetResult* result_ = nullptr;
};

/// Reference solution of a wheelset by its balance itself, which accepts finer grids than WheelsetContact.
/// @param tolerance  of height and roll [-]
Outcome wheelsetReference(const std::vector<ParameterSource>& sources, const core::GridLevels& levels, double y,
                          double force_z, double tolerance)
{
  core::ContactModelConfig config = modelOf(sources);
  config.contact.tolerance = tolerance;
  core::WheelsetBalance balance(config, levels);
  Outcome outcome;
  outcome.usable = isUsable(balance.solve(stateAt(y, force_z)));
  outcome.reason = balance.reason();
  std::vector<core::PatchResult> patches;
  for (const core::Side side : core::sides)
  {
    const bool loaded = outcome.usable && balance.wheel(side).loaded();
    for (std::size_t k = 0; loaded && k < balance.islands(side).islands().size(); ++k)
    {
      fillPatch(side, balance, k, patches.emplace_back());
    }
  }
  addWheels(patches, outcome);
  return outcome;
}

void bindRuns(py::module& module)
{
  py::class_<WheelOutcome>(module, "WheelOutcome")
      .def_readonly("index", &WheelOutcome::index)
      .def_readonly("max_pressure", &WheelOutcome::max_pressure)
      .def_readonly("area", &WheelOutcome::area)
      .def_readonly("approach", &WheelOutcome::approach);
  py::class_<Outcome>(module, "Outcome")
      .def_readonly("usable", &Outcome::usable)
      .def_readonly("reason", &Outcome::reason)
      .def_property_readonly(
          "grid", [](const Outcome& outcome) { return std::make_pair(outcome.grid.along, outcome.grid.across); })
      .def_readonly("wheels", &Outcome::wheels)
      .def_readonly("estimate", &Outcome::estimate);
  py::class_<TimedRun>(module, "TimedRun")
      .def("solve", &TimedRun::solve)
      .def("reset", &TimedRun::reset)
      .def("outcome", &TimedRun::outcome)
      .def("time", &TimedRun::time, py::arg("states"), py::arg("cold") = false)
      .def("times", &TimedRun::times);
}

void bindTimedWheelsets(py::module& module)
{
  py::class_<core::WheelsetContact, SharedWheelset>(module, "TimedWheelset")
      .def(py::init([](const std::vector<ParameterSource>& sources)
                    { return std::make_shared<core::WheelsetContact>(modelOf(sources)); }));
  py::class_<WheelsetRun, TimedRun>(module, "WheelsetRun")
      .def(py::init<SharedWheelset, const std::vector<double>&, double>());
  module.def("wheelset_reference", &wheelsetReference);
}
}  // namespace

void bindTiming(py::module& module)
{
  module.attr("BUILD") = py::dict(py::arg("version") = CHART_VERSION, py::arg("compiler") = CHART_COMPILER,
                                  py::arg("build") = CHART_BUILD_TYPE);
  bindRuns(module);
  bindTimedGaps(module);
  bindTimedWheelsets(module);
}
}  // namespace wheel_rail_contact
