// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "benchmarks.h"

namespace wheel_rail_contact
{
namespace
{
void search(benchmark::State& state)
{
  OneWheel one;
  Sweep sweep;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(one.wheel.touch({sweep.next().y, 0, 0, 0}).axle_height);
  }
}

void gap(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one;
  core::PatchGap patch = one.problemOn(size).patches[0];
  const core::RigidTouch touch = one.wheel.touch({0, 0, 0, 0});
  const core::PlacedWheel placed(*one.config.wheel_profile, one.config.wheelset, {0, touch.axle_height, 0, 0});
  std::vector<core::GapColumn> columns;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(buildGap(placed, one.rail, one.wheel.patches()[0].plane, patch.grid, patch.gap, columns));
  }
}

void normal(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one;
  const core::NormalProblem problem = one.problemOn(size);
  core::NormalSolution solution;
  for (auto _ : state)
  {
    one.solver.solve(problem, false, solution);
    benchmark::DoNotOptimize(solution.approach);
  }
  state.counters["products"] = solution.iterations;
}

void estimate(benchmark::State& state, const core::GridSize& size)
{
  OneWheel one;
  one.problemOn(size);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(one.wheel.estimateErrors().data());
  }
}
}  // namespace

void registerSteps()
{
  benchmark::RegisterBenchmark("step/search", search)->Unit(benchmark::kMicrosecond);
  for (const core::GridSize& size : {core::GridSize{10, 24}, core::GridSize{12, 32}, core::GridSize{16, 48},
                                     core::GridSize{24, 56}, core::GridSize{32, 96}, core::GridSize{64, 128}})
  {
    const auto add = [&](const std::string& name, void (*run)(benchmark::State&, const core::GridSize&))
    {
      benchmark::RegisterBenchmark((name + nameOf(size)).c_str(), [=](benchmark::State& state) { run(state, size); })
          ->Unit(benchmark::kMicrosecond);
    };
    add("step/gap/", gap);
    add("step/normal/", normal);
    add("step/error_estimate/", estimate);
  }
}
}  // namespace wheel_rail_contact
