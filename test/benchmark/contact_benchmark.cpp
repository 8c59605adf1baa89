// SPDX-License-Identifier: BSD-3-Clause
// Speed of the whole chain and of its steps: S1002 on UIC60, 100 kN a wheel, y from -6 mm to 6 mm and back in steps of
// 0.05 mm, one core. Report medians: contact_benchmark --benchmark_repetitions=9 --benchmark_report_aggregates_only
#include <benchmark/benchmark.h>

#include <string>

#include "../manchester_scene.h"
#include "wheel_rail_contact/balance/wheel_contact.h"
#include "wheel_rail_contact/geometry/contact_search.h"
#include "wheel_rail_contact/normal/conjugate_gradients.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int half_sweep = 120;   ///< steps from the middle to either end
constexpr double step = 0.05e-3;  ///< [m]

/// The states of the sweep, there and back, again and again.
class Sweep
{
 public:
  const WheelsetState& next()
  {
    const int period = 4 * half_sweep;
    const int place = count_++ % period;
    const int k = place < 2 * half_sweep ? place : period - place;
    state_.y = (k - half_sweep) * step;
    return state_;
  }

 private:
  WheelsetState state_{0, 0, 0, 0, -200e3, 0, {}};
  int count_ = 0;
};

enum class Start
{
  cold,
  warm
};

void evaluate(benchmark::State& state, const ContactModelConfig& config, Start start)
{
  WheelsetContact contact(config);
  Sweep sweep;
  contact.evaluate(sweep.next());
  int refused = 0;
  for (auto _ : state)
  {
    if (start == Start::cold)
    {
      contact.reset();
    }
    refused += isUsable(contact.evaluate(sweep.next()).status) ? 0 : 1;
  }
  state.counters["refused"] = refused;
}

void registerWheelset(const std::string& name, const ContactModelConfig& config, Start start)
{
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { evaluate(state, config, start); })
      ->Unit(benchmark::kMicrosecond);
}

void registerWheelsets()
{
  for (const char* tolerance : {"0.1", "0.01", "0.003"})
  {
    ContactModelConfig config = manchesterScene();
    config.contact.tolerance = std::stod(tolerance);
    registerWheelset(std::string("wheelset/cold/") + tolerance, config, Start::cold);
    registerWheelset(std::string("wheelset/warm/") + tolerance, config, Start::warm);
  }
  ContactModelConfig bending = manchesterScene();
  bending.rail_bending.model = RailBendingConfig::Model::compliance;
  bending.rail_bending.table = softPads();
  registerWheelset("wheelset_bending/cold/0.01", bending, Start::cold);
  registerWheelset("wheelset_bending/warm/0.01", bending, Start::warm);
}

/// One wheel on one rail, to be stepped through by hand.
struct OneWheel
{
  ContactModelConfig config = manchesterScene();
  PlacedRail rail{config.rail_profile, config.track};
  ConjugateGradients solver;
  WheelContact wheel{config, solver};

  OneWheel() { wheel.setRail(rail); }
};

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
  const RigidTouch touch = one.wheel.touch({0, 0, 0, 0});
  one.wheel.solveLoad(touch, 100e3, size);
  const PlacedWheel placed(*one.config.wheel_profile, one.config.wheelset, {0, touch.axle_height, 0, 0});
  PatchGap patch = one.wheel.problem().patches[0];
  std::vector<GapColumn> columns;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(buildGap(placed, one.rail, one.wheel.patches()[0].plane, patch.grid, patch.gap, columns));
  }
}

void normal(benchmark::State& state, const GridSize& size)
{
  OneWheel one;
  one.wheel.solveLoad(one.wheel.touch({0, 0, 0, 0}), 100e3, size);
  const NormalProblem problem = one.wheel.problem();
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
  one.wheel.solveLoad(one.wheel.touch({0, 0, 0, 0}), 100e3, size);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(one.wheel.errorEstimate());
  }
}

void registerSteps()
{
  benchmark::RegisterBenchmark("step/search", search)->Unit(benchmark::kMicrosecond);
  for (const GridSize& size : {GridSize{8, 16}, GridSize{8, 24}, GridSize{16, 32}, GridSize{16, 64}, GridSize{32, 64},
                               GridSize{32, 128}, GridSize{64, 128}, GridSize{128, 256}, GridSize{256, 256}})
  {
    const std::string grid = std::to_string(size.along) + "x" + std::to_string(size.across);
    const auto add = [&](const std::string& name, void (*run)(benchmark::State&, const GridSize&))
    {
      benchmark::RegisterBenchmark((name + grid).c_str(), [=](benchmark::State& state) { run(state, size); })
          ->Unit(benchmark::kMicrosecond);
    };
    add("step/gap/", gap);
    add("step/normal/", normal);
    add("step/error_estimate/", estimate);
  }
}
}  // namespace
}  // namespace wheel_rail_contact

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 1;
  }
  wheel_rail_contact::registerWheelsets();
  wheel_rail_contact::registerSteps();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
