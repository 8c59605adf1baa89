// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks.h"
#include "core/balance/wheelset_balance.h"

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

/// Distribution of the CPU times of 20 001 evaluations from a warm start [ms]: y from -8 to 8 mm in steps of 0.8 um,
/// through flange contact on either side and all jumps of the contact between them.
void worst(benchmark::State& state, const core::ContactModelConfig& config)
{
  constexpr int steps = 20000;
  constexpr double first = -8e-3, step = 0.8e-6;  // [m]
  core::WheelsetContact contact(config);
  core::WheelsetState at;
  at.y = first;
  at.force_z = -200e3;
  contact.evaluate(at);
  std::vector<double> times;
  int unusable = 0;
  for (auto _ : state)
  {
    for (int k = 0; k <= steps; ++k)
    {
      at.y = first + k * step;
      const double before = threadTime();
      const core::WheelsetResult& result = contact.evaluate(at);
      times.push_back(1e3 * (threadTime() - before));
      unusable += isUsable(result.status) ? 0 : 1;
    }
  }
  std::sort(times.begin(), times.end());
  state.counters["median_ms"] = times[times.size() / 2];
  state.counters["p95_ms"] = times[times.size() * 95 / 100];
  state.counters["p99_ms"] = times[times.size() * 99 / 100];
  state.counters["max_ms"] = times.back();
  state.counters["unusable"] = unusable;
}

/// Wrapper of a solver that measures its time.
class TimedSolver : public core::NormalSolver
{
 public:
  TimedSolver(std::unique_ptr<core::NormalSolver> solver, double& spent) : solver_(std::move(solver)), spent_(spent) {}

  const char* name() const override { return solver_->name(); }
  void solve(const core::NormalProblem& problem, bool warm, core::NormalSolution& solution) override
  {
    spent_ += seconds([&] { solver_->solve(problem, warm, solution); });
  }
  void solveCurved(const core::CurvedProblem& problem, bool warm, core::NormalSolution& solution) override
  {
    spent_ += seconds([&] { solver_->solveCurved(problem, warm, solution); });
  }
  void estimateErrors(const core::NormalProblem& problem, const core::NormalSolution& solution,
                      std::vector<core::ErrorEstimate>& errors) const override
  {
    spent_ += seconds([&] { solver_->estimateErrors(problem, solution, errors); });
  }

 private:
  std::unique_ptr<core::NormalSolver> solver_;
  double& spent_;  ///< time of both functions [s]
};

/// Time of one result, and the part of it spent in normal solutions and error estimates [s].
struct Message
{
  double all, solutions;
};

/// Share of the solutions in the time of some results [%].
double shareOf(std::vector<Message>::const_iterator begin, std::vector<Message>::const_iterator end)
{
  double all = 0, solutions = 0;
  for (; begin != end; ++begin)
  {
    all += begin->all;
    solutions += begin->solutions;
  }
  return 100 * solutions / all;
}

/// Share of the normal solutions in the time of results from a warm start [%]. The remaining time is search, gap and
/// balance. `solutions_%` is the share over all results. `solutions_at_median_%` is the share over the tenth of the
/// results about the median, which excludes expensive results (jumps, finer grids).
void shareOfSolutions(benchmark::State& state, const core::ContactModelConfig& config, BackAndForth motion)
{
  constexpr std::size_t count = 4800, first = 480;
  double spent = 0;
  const core::GridLevels levels(config, [&](std::unique_ptr<core::NormalSolver> solver)
                                { return std::make_unique<TimedSolver>(std::move(solver), spent); });
  core::WheelsetBalance balance(config, levels);
  std::vector<Message> messages;
  for (auto _ : state)
  {
    messages.clear();
    for (std::size_t k = 0; k < first + count; ++k)
    {
      const core::WheelsetState& now = motion.next();
      const double before = spent;
      const double all = seconds([&] { balance.solve(now); });
      if (k >= first)
      {
        messages.push_back({all, spent - before});
      }
    }
  }
  state.counters["solutions_%"] = shareOf(messages.begin(), messages.end());
  std::sort(messages.begin(), messages.end(), [](const Message& a, const Message& b) { return a.all < b.all; });
  state.counters["solutions_at_median_%"] =
      shareOf(messages.begin() + count * 45 / 100, messages.begin() + count * 55 / 100);
  state.counters["median_us"] = 1e6 * messages[count / 2].all;
}

/// Shares over the sweep, and for lateral motions of ± 0.2 mm about several mean displacements.
void addShares(const std::string& tolerance, const core::ContactModelConfig& config)
{
  const auto register_share = [](const std::string& name, auto share)
  { benchmark::RegisterBenchmark(name.c_str(), share)->Unit(benchmark::kMillisecond)->Iterations(1); };
  register_share("wheelset/solutions/" + tolerance,
                 [config](benchmark::State& state) { shareOfSolutions(state, config, Sweep()); });
  for (const char* place : {"0", "0.5", "3", "5", "6.5"})
  {
    register_share("wheelset/solutions/" + tolerance + "/" + place + "mm",
                   [config, y = 1e-3 * std::stod(place)](benchmark::State& state)
                   { shareOfSolutions(state, config, BackAndForth(y, 4)); });
  }
}

void addWorst(const core::Profile& rail, const std::string& tolerance)
{
  core::ContactModelConfig config = core::manchesterScene();
  config.rail_profile = std::make_shared<core::Profile>(rail);
  config.contact.tolerance = std::stod(tolerance);
  benchmark::RegisterBenchmark(("wheelset/worst/" + rail.name() + "/" + tolerance).c_str(),
                               [=](benchmark::State& state) { worst(state, config); })
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
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
    addShares(tolerance, config);
  }
  core::ContactModelConfig stress = core::manchesterScene();
  stress.stress.depths = 16;
  add("wheelset_stress/warm/0.01", stress, Start::warm);
  core::ContactModelConfig bending = core::manchesterScene();
  bending.rail_bending.model = core::RailBendingConfig::Model::compliance;
  bending.rail_bending.table = core::softPads();
  add("wheelset_bending/cold/0.01", bending, Start::cold);
  add("wheelset_bending/warm/0.01", bending, Start::warm);
  for (const core::Profile& rail : {core::rail60E1(), core::railUic60Manchester()})
  {
    addWorst(rail, "0.1");
    addWorst(rail, "0.01");
  }
}
}  // namespace wheel_rail_contact
