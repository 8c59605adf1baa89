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

void gap(benchmark::State& state, const GridSize& size)
{
  OneWheel one;
  PatchGap patch = one.problemOn(size).patches[0];
  const RigidTouch touch = one.wheel.touch({0, 0, 0, 0});
  const PlacedWheel placed(*one.config.wheel_profile, one.config.wheelset, {0, touch.axle_height, 0, 0});
  std::vector<GapColumn> columns;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(buildGap(placed, one.rail, one.wheel.patches()[0].plane, patch.grid, patch.gap, columns));
  }
}

void normal(benchmark::State& state, const GridSize& size)
{
  OneWheel one;
  const NormalProblem problem = one.problemOn(size);
  NormalSolution solution;
  for (auto _ : state)
  {
    one.solver.solve(problem, false, solution);
    benchmark::DoNotOptimize(solution.approach);
  }
  state.counters["products"] = solution.iterations;
}

void estimate(benchmark::State& state, const GridSize& size)
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
  for (const GridSize& size :
       {GridSize{10, 24}, GridSize{12, 32}, GridSize{16, 48}, GridSize{24, 56}, GridSize{32, 96}, GridSize{64, 128}})
  {
    const auto add = [&](const std::string& name, void (*run)(benchmark::State&, const GridSize&))
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
