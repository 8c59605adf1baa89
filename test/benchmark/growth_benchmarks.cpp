// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "benchmarks.h"

namespace wheel_rail_contact
{
namespace
{
/// Shortest time of nine solutions from a cold start [s].
double shortestSolution(OneWheel& one, const core::NormalProblem& problem)
{
  constexpr int tries = 9;
  double shortest = INFINITY;
  core::NormalSolution solution;
  for (int k = 0; k < tries; ++k)
  {
    shortest = std::min(shortest, seconds([&] { one.solver.solve(problem, false, solution); }));
  }
  return shortest;
}

/// Solutions from a cold start on grids of 4×16 to 256×256 cells. `exponent` is the slope of the regression line
/// through the logarithms of time and number of cells.
void cells(benchmark::State& state)
{
  constexpr std::array<core::GridSize, 7> sizes{
      {{4, 16}, {8, 32}, {16, 64}, {32, 64}, {64, 128}, {128, 256}, {256, 256}}};
  OneWheel one;
  std::array<double, sizes.size()> time{};
  for (auto _ : state)
  {
    for (std::size_t k = 0; k < sizes.size(); ++k)
    {
      time[k] = shortestSolution(one, one.flatProblemOn(sizes[k]));
    }
  }
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < sizes.size(); ++k)
  {
    const double log_cells = std::log(sizes[k].along * sizes[k].across), log_time = std::log(time[k]);
    x += log_cells;
    y += log_time;
    xx += log_cells * log_cells;
    xy += log_cells * log_time;
    state.counters[nameOf(sizes[k]) + "_us"] = 1e6 * time[k];
  }
  const auto n = static_cast<double>(sizes.size());
  state.counters["exponent"] = (n * xy - x * y) / (n * xx - x * x);
}

/// Solution from a cold start for `count` copies of the patch of a wheel, under `count` times its load.
void patches(benchmark::State& state, int count)
{
  OneWheel one;
  core::NormalProblem problem = one.flatProblemOn({16, 48});
  problem.patches.resize(static_cast<std::size_t>(count), problem.patches[0]);
  problem.value *= count;
  core::NormalSolution solution;
  for (auto _ : state)
  {
    one.solver.solve(problem, false, solution);
    benchmark::DoNotOptimize(solution.approach);
  }
}

/// Evaluations of several wheelsets in turn, from a warm start. Each is at a different position of the sweep.
void wheelsets(benchmark::State& state, int count)
{
  constexpr int apart = 15;  // steps of the sweep
  std::vector<core::WheelsetContact> contacts;
  std::vector<Sweep> sweeps(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    contacts.emplace_back(core::manchesterScene());
    for (int step = 0; step < k * apart; ++step)
    {
      sweeps[static_cast<std::size_t>(k)].next();
    }
  }
  for (auto _ : state)
  {
    for (std::size_t k = 0; k < contacts.size(); ++k)
    {
      benchmark::DoNotOptimize(contacts[k].evaluate(sweeps[k].next()).z);
    }
  }
  state.SetItemsProcessed(state.iterations() * count);
}
}  // namespace

void registerGrowth()
{
  benchmark::RegisterBenchmark("growth/cells", cells)->Unit(benchmark::kMillisecond)->Iterations(1);
  for (const int count : {1, 2, 3, 4})
  {
    const std::string name = "growth/patches/" + std::to_string(count);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { patches(state, count); })
        ->Unit(benchmark::kMicrosecond);
  }
  for (const int count : {1, 2, 4, 8, 16, 32})
  {
    const std::string name = "growth/wheelsets/" + std::to_string(count);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { wheelsets(state, count); })
        ->Unit(benchmark::kMicrosecond);
  }
}
}  // namespace wheel_rail_contact
