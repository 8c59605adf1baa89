// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cmath>

#include "benchmarks.h"
#include "core/normal/solvers/seidel.h"
#include "polonsky_keer.h"

namespace wheel_rail_contact
{
namespace
{
/// Solves one problem alternately by conjugate gradients and by another solver, both from a cold start.
/// Counters: `time_ratio` is the time of the other solver over that of conjugate gradients; `approach_difference` is
/// the relative difference of their approaches.
/// @param other solves a problem and returns the approach [m]
template <typename Other>
void compare(benchmark::State& state, const core::GridSize& size, Other other)
{
  OneWheel one;
  const core::NormalProblem problem = one.flatProblemOn(size);
  core::NormalSolution solution;
  double own_time = 0, other_time = 0, other_approach = 0;
  for (auto _ : state)
  {
    own_time += seconds([&] { one.solver.solve(problem, false, solution); });
    other_time += seconds([&] { other_approach = other(problem); });
  }
  state.counters["time_ratio"] = other_time / own_time;
  state.counters["approach_difference"] = std::abs(other_approach / solution.approach - 1);
}

void seidel(benchmark::State& state, const core::GridSize& size, core::SeidelOptions::Form form)
{
  core::SeidelOptions options;
  options.form = form;
  core::Seidel solver(options);
  core::NormalSolution solution;
  compare(state, size,
          [&](const core::NormalProblem& problem)
          {
            solver.solve(problem, false, solution);
            return solution.approach;
          });
}

void polonskyKeer(benchmark::State& state, const core::GridSize& size)
{
  PolonskyKeer solver(core::ConjugateGradientsOptions().residual);
  bool found = true;
  compare(state, size,
          [&](const core::NormalProblem& problem)
          {
            found = solver.solve(problem) && found;
            return solver.approach();
          });
  state.counters["products"] = solver.products();
  if (!found)
  {
    state.SkipWithError("Polonsky-Keer did not reach the residual");
  }
}

/// Evaluations of a wheelset from a warm start, alternately on rails with a compliance table and on rigid rails, over
/// one sweep. Counters: `time_ratio` is the time with the table over that on rigid rails; `unusable` is the number of
/// unusable results.
void bendingRails(benchmark::State& state)
{
  core::ContactModelConfig config = core::manchesterScene();
  core::WheelsetContact rigid(config);
  config.rail_bending.model = core::RailBendingConfig::Model::compliance;
  config.rail_bending.table = core::softPads();
  core::WheelsetContact bending(config);
  Sweep sweep;
  double rigid_time = 0, bending_time = 0;
  int unusable = 0;
  for (auto _ : state)
  {
    const core::WheelsetState& wheelset = sweep.next();
    rigid_time += seconds([&] { unusable += isUsable(rigid.evaluate(wheelset).status) ? 0 : 1; });
    bending_time += seconds([&] { unusable += isUsable(bending.evaluate(wheelset).status) ? 0 : 1; });
  }
  state.counters["time_ratio"] = bending_time / rigid_time;
  state.counters["unusable"] = unusable;
}
}  // namespace

void registerRatios()
{
  const auto add = [](const std::string& name, auto run)
  { benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond); };
  add("ratio/bending_rails", bendingRails);
  for (const core::GridSize& size : {core::GridSize{16, 16}, core::GridSize{16, 32}, core::GridSize{32, 32}})
  {
    add("ratio/seidel_printed/" + nameOf(size),
        [=](benchmark::State& state) { seidel(state, size, core::SeidelOptions::Form::printed); });
    add("ratio/seidel/" + nameOf(size),
        [=](benchmark::State& state) { seidel(state, size, core::SeidelOptions::Form::repaired); });
  }
  for (const core::GridSize& size : {core::GridSize{16, 48}, core::GridSize{32, 64}, core::GridSize{64, 128}})
  {
    add("ratio/polonsky_keer/" + nameOf(size), [=](benchmark::State& state) { polonskyKeer(state, size); });
  }
}
}  // namespace wheel_rail_contact
