// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "benchmarks.h"
#include "core/balance/patch_result.h"
#include "core/friction/rolling_wheelset.h"
#include "core/normal/estimate/islands.h"
#include "core/stress/stress_search.h"
#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact
{
namespace
{
/// Placement of the wheel and search for the smallest separation.
void search(benchmark::State& state)
{
  constexpr double above = 0.01;  // no overlap, so no grid is laid [m]
  OneWheel one;
  Sweep sweep;
  for (auto _ : state)
  {
    one.wheel.touch({sweep.next().y, one.config.wheelset.rolling_radius.left + above, 0, 0});
    benchmark::DoNotOptimize(one.wheel.height());
  }
}

/// The gap of one grid.
void gap(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one(size);
  const core::PlacedWheel placed(*one.config.wheel_profile.left, one.config.wheelset, core::Side::left, one.pose);
  const core::SurfaceOrigin origin = one.wheel.grids().originOf(0);
  const core::Grid grid = one.wheel.problem().patches[0].grid;
  Eigen::ArrayXXd gaps, slope;
  std::vector<core::SurfaceColumn> columns;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(buildSurfaceGap(placed, one.rail, origin, grid, gaps, slope, columns));
  }
}

/// All that precedes the normal solution: search, overlap, grids and gaps.
void problem(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one(size);
  core::OverlapGrids grids(one.config, core::Side::left, one.rail);
  grids.setRail(one.rail);
  core::CurvedProblem built;
  built.modulus = one.wheel.problem().modulus;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(
        grids.build(one.pose, size, core::OverlapGrids::Choice::own, core::OverlapGrids::Reach::expected, built));
  }
}

void normal(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one(size);
  const core::CurvedProblem problem = one.wheel.problem();
  core::NormalSolution solution;
  for (auto _ : state)
  {
    one.solver.solveCurved(problem, false, solution);
    benchmark::DoNotOptimize(solution.approach);
  }
  state.counters["products"] = solution.iterations;
}

/// Islands of the contact and their error estimates.
void estimate(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one(size);
  core::Islands islands;
  std::vector<core::ErrorEstimate> errors;
  for (auto _ : state)
  {
    islands.find(one.wheel.problem(), one.wheel.solution());
    one.solver.estimateErrors(islands.problem(), islands.solution(), errors);
    benchmark::DoNotOptimize(errors.data());
  }
}

/// Stiffness of the contact: slopes for the balance of the wheelset and for bending rails.
void stiffness(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one(size);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(one.wheel.stiffness()(core::wheel_up, core::wheel_up));
  }
}
/// Pressure of the first patch, and its grid from the centre of the cells.
struct Pressed
{
  core::PatchGrid grid;
  Eigen::ArrayXXd pressure;
  core::SemiAxes axes;

  explicit Pressed(const core::PatchPressure& patch) : axes(core::equalEllipse(patch))
  {
    const core::Grid& cells = patch.grid;
    grid = {cells.nx, cells.ny, cells.dx, cells.dy, (0.5 - 0.5 * cells.nx) * cells.dx, cells.y0};
    core::wholePressure(core::Side::left, cells, patch.pressure, pressure);
  }
};

/// Creep force of a patch whose pressure is known, at two thirds of the friction limit, with spin. Each starts cold.
template <core::CreepMethod method>
void creep(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one(size);
  const Pressed pressed(one.wheel.solution().patches[0]);
  core::CreepProblem problem;
  problem.creepage = {1e-3, 5e-4, 0.1};
  problem.normal_force = one.wheel.solution().patches[0].force;
  problem.semi_axis_along = pressed.axes.along;
  problem.semi_axis_across = pressed.axes.across;
  problem.grid = pressed.grid;
  problem.pressure = pressed.pressure;
  const auto solver = makeCreepSolver(method);
  core::CreepSolution solution;
  for (auto _ : state)
  {
    solver->solve(problem, false, solution);
    benchmark::DoNotOptimize(solution.force);
  }
  state.counters["sweeps"] = solution.iterations;
}

/// Friction in the columns of both wheels of a wheelset that rolls freely, with yaw, from the last tractions.
template <core::CreepMethod method>
void friction(benchmark::State& state, const core::GridSize& size)
{
  core::ContactModelConfig config = core::manchesterScene();
  config.creep.method = method;
  config.contact.cells_along = size.along;
  config.contact.cells_across = size.across;
  const core::GridLevels levels(config);
  core::WheelsetBalance balance(config, levels);
  core::WheelsetState at = Sweep().next();
  at.y = 0;
  balance.solve(at);
  core::RollingWheelset rolling(config);
  int unusable = 0;
  for (auto _ : state)
  {
    at.yaw = 1e-3 - at.yaw;
    unusable += rolling.solve(at, balance).empty() ? 0 : 1;
  }
  state.counters["unusable"] = unusable;
}

/// Search for the highest stresses beneath a patch.
void stress(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one(size);
  const Pressed pressed(one.wheel.solution().patches[0]);
  core::StressSearch search;
  for (auto _ : state)
  {
    search.set(pressed.grid, pressed.pressure, {0, pressed.grid.ny}, pressed.axes);
    benchmark::DoNotOptimize(search.find(0.28).von_mises.value);
  }
}

/// Stress in 16 layers.
void stressField(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one(size);
  const Pressed pressed(one.wheel.solution().patches[0]);
  std::vector<double> depths;
  for (int k = 0; k < 16; ++k)
  {
    depths.push_back(k * pressed.axes.across / 8);
  }
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(stressLayers(pressed.grid, pressed.pressure, 0.28, depths).size());
  }
}
}  // namespace

void registerSteps()
{
  benchmark::RegisterBenchmark("step/search", search)->Unit(benchmark::kMicrosecond);
  for (const core::GridSize& size :
       {core::GridSize{8, 16}, core::GridSize{12, 24}, core::GridSize{16, 32}, core::GridSize{16, 48},
        core::GridSize{24, 64}, core::GridSize{32, 96}, core::GridSize{64, 192}})
  {
    const auto add = [&](const std::string& name, void (*run)(benchmark::State&, const core::GridSize&))
    {
      benchmark::RegisterBenchmark((name + nameOf(size)).c_str(), [=](benchmark::State& state) { run(state, size); })
          ->Unit(benchmark::kMicrosecond);
    };
    add("step/gap/", gap);
    add("step/problem/", problem);
    add("step/normal/", normal);
    add("step/error_estimate/", estimate);
    add("step/stiffness/", stiffness);
    add("step/stress/", stress);
    add("step/stress_field/", stressField);
    if (size == core::GridSize{12, 24} || size == core::GridSize{24, 64})
    {
      add("step/creep/linear/", creep<core::CreepMethod::linear>);
      add("step/creep/fastsim/", creep<core::CreepMethod::fastsim>);
      add("step/creep/exact/", creep<core::CreepMethod::exact>);
      add("step/friction/linear/", friction<core::CreepMethod::linear>);
      add("step/friction/fastsim/", friction<core::CreepMethod::fastsim>);
      add("step/friction/exact/", friction<core::CreepMethod::exact>);
    }
  }
}
}  // namespace wheel_rail_contact
