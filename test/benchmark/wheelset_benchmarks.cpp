// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "benchmarks.h"

namespace wheel_rail_contact
{
namespace
{
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

/// Spread of the times of 20 000 warm evaluations [us].
void jitter(benchmark::State& state, const ContactModelConfig& config)
{
  constexpr std::size_t count = 20000;
  WheelsetContact contact(config);
  Sweep sweep;
  contact.evaluate(sweep.next());
  std::vector<double> times(count);
  for (auto _ : state)
  {
    for (double& time : times)
    {
      time = 1e6 * seconds([&] { contact.evaluate(sweep.next()); });
    }
  }
  std::sort(times.begin(), times.end());
  state.counters["median_us"] = times[count / 2];
  state.counters["p95_us"] = times[count * 95 / 100];
  state.counters["p99_us"] = times[count * 99 / 100];
  state.counters["max_us"] = times.back();
}

void add(const std::string& name, const ContactModelConfig& config, Start start)
{
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { evaluate(state, config, start); })
      ->Unit(benchmark::kMicrosecond);
}
}  // namespace

void registerWheelsets()
{
  for (const char* tolerance : {"0.1", "0.03", "0.01", "0.003"})
  {
    ContactModelConfig config = manchesterScene();
    config.contact.tolerance = std::stod(tolerance);
    add(std::string("wheelset/cold/") + tolerance, config, Start::cold);
    add(std::string("wheelset/warm/") + tolerance, config, Start::warm);
  }
  ContactModelConfig bending = manchesterScene();
  bending.rail_bending.model = RailBendingConfig::Model::compliance;
  bending.rail_bending.table = softPads();
  add("wheelset_bending/cold/0.01", bending, Start::cold);
  add("wheelset_bending/warm/0.01", bending, Start::warm);
  benchmark::RegisterBenchmark("wheelset/jitter/0.01",
                               [](benchmark::State& state) { jitter(state, manchesterScene()); })
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
}
}  // namespace wheel_rail_contact
