// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

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

void evaluate(benchmark::State& state, const core::ContactModelConfig& config, Start start)
{
  core::WheelsetContact contact(config);
  Sweep sweep;
  contact.evaluate(sweep.next());
  int unusable = 0;
  for (auto _ : state)
  {
    if (start == Start::cold)
    {
      contact.reset();
    }
    unusable += isUsable(contact.evaluate(sweep.next()).status) ? 0 : 1;
  }
  state.counters["unusable"] = unusable;
}

void add(const std::string& name, const core::ContactModelConfig& config, Start start)
{
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { evaluate(state, config, start); })
      ->Unit(benchmark::kMicrosecond);
}
}  // namespace

void registerWheelsets()
{
  for (const char* tolerance : {"0.1", "0.03", "0.01", "0.003"})
  {
    core::ContactModelConfig config = core::manchesterScene();
    config.contact.tolerance = std::stod(tolerance);
    add(std::string("wheelset/cold/") + tolerance, config, Start::cold);
    add(std::string("wheelset/warm/") + tolerance, config, Start::warm);
  }
  for (const core::CreepMethod method : {core::CreepMethod::fastsim, core::CreepMethod::exact})
  {
    core::ContactModelConfig friction = core::manchesterScene();
    friction.creep.method = method;
    add(std::string("wheelset_friction/warm/") + toString(method), friction, Start::warm);
  }
  core::ContactModelConfig stress = core::manchesterScene();
  stress.stress.depths = 16;
  add("wheelset_stress/warm/0.01", stress, Start::warm);
  const core::ContactModelConfig bending = core::onPads(core::softPads());
  add("wheelset_bending/cold/0.01", bending, Start::cold);
  add("wheelset_bending/warm/0.01", bending, Start::warm);
}
}  // namespace wheel_rail_contact
