// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

#include "../pairs_bag.h"
#include "../standard_headers.h"
#include "../temporary_folder.h"
#include "benchmarks.h"
#include "replay/replay.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int pairs = 20000;
constexpr int runs = 5;

/// Wall time and processor time of a run [s].
struct Cost
{
  double wall = 0, cpu = 0;
};

template <typename Work>
void addCost(const Work& work, Cost& sum)
{
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const std::clock_t cpu = std::clock();  // processor time of all threads
  work();
  sum.wall += std::chrono::duration<double>(Clock::now() - begin).count();
  sum.cpu += static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
}

/// Inputs of the bag, divided into slices (see ResetRule).
/// @param lateral lateral displacements [m]
std::vector<std::vector<PreparedInput>> slicesOf(const std::vector<double>& lateral)
{
  std::vector<std::vector<PreparedInput>> slices;
  ResetRule reset_rule;
  for (int i = 0; i < pairs; ++i)
  {
    PreparedInput input;
    input.stamp = stampOf(i);
    input.state = {lateral[static_cast<std::size_t>(i)], 0, 0, 0, -200e3, 0, {}};
    input.resets = reset_rule.resets(input.stamp);
    if (input.resets)
    {
      slices.emplace_back();
    }
    slices.back().push_back(input);
  }
  return slices;
}

/// Evaluates all slices without reading or writing. Each thread repeatedly takes the next slice.
void evaluateAll(const std::vector<std::vector<PreparedInput>>& slices, std::vector<ContactEvaluator>& evaluators)
{
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (ContactEvaluator& evaluator : evaluators)
  {
    threads.emplace_back(
        [&]
        {
          for (std::size_t k = next++; k < slices.size(); k = next++)
          {
            for (const PreparedInput& input : slices[k])
            {
              benchmark::DoNotOptimize(evaluator.evaluate(input));
            }
          }
        });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

/// Evaluates the same pairs alternately from bag to bag by contact_replay and without bags. Counters: `wall` and `cpu`
/// are wall time and processor time of contact_replay over those of the evaluations alone; `per_s` is the number of
/// results per second of contact_replay. The influence coefficients, which a process computes once, are not included.
void replay(benchmark::State& state, int threads)
{
  const Folder folder;
  Sweep sweep;
  std::vector<double> lateral(pairs);
  for (double& y : lateral)
  {
    y = sweep.next().y;
  }
  writePairs(folder.path("in.bag"), pairs, [&](int i) { return lateral[static_cast<std::size_t>(i)]; });
  ReplayOptions options;
  options.input = folder.path("in.bag");
  options.output = folder.path("out.bag");
  options.configs = {folder.write("a.yaml", "{rail: {profile: UIC60_manchester}, contact: {tolerance: 0.01}}\n")};
  options.threads = threads;
  const NodeConfig config = readNodeConfig(replayParameters(options), "", {});
  std::vector<ContactEvaluator> evaluators;
  for (int i = 0; i < threads; ++i)
  {
    evaluators.emplace_back(config);
  }
  const auto slices = slicesOf(lateral);
  const std::atomic<bool> interrupted{false};
  Cost whole, pure;
  for (auto _ : state)
  {
    addCost([&] { evaluateAll(slices, evaluators); }, pure);
    std::filesystem::remove(options.output);
    addCost([&] { Replay(options).run(interrupted); }, whole);
  }
  state.counters["per_s"] = runs * pairs / whole.wall;
  state.counters["wall"] = whole.wall / pure.wall;
  state.counters["cpu"] = whole.cpu / pure.cpu;
}
}  // namespace

void registerReplay()
{
  for (const int threads : {1, 2})
  {
    benchmark::RegisterBenchmark(("replay/0.01/threads:" + std::to_string(threads)).c_str(),
                                 [=](benchmark::State& state) { replay(state, threads); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(runs);
  }
}
}  // namespace wheel_rail_contact
