// SPDX-License-Identifier: BSD-3-Clause
#include "chart/comparison.h"

#include <algorithm>
#include <ctime>
#include <numeric>
#include <stdexcept>

#include "chart/quantile.h"

namespace wheel_rail_contact::core::chart
{
namespace
{
constexpr int warm_up = 4 * longest_reach;  ///< untimed messages at the start, within warm_up_time
constexpr double warm_up_time = 0.1;        ///< [s]
constexpr double fast = 5e-3;         ///< mean time of a result up to which timing and inspection are separate [s]
constexpr double visit_time = 1e-3;   ///< time of one visit [s]
constexpr double enough_time = 0.05;  ///< time after which few results are sufficient [s]
constexpr std::size_t few = 3;
constexpr double enough_sweep_time = 0.1;  ///< time of the sweeps of a method after which no other one begins [s]

/// CPU time of this thread [s], independent of other processes.
double now()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Reference solutions at all positions.
class Truths
{
 public:
  Truths(Scene& scene, const GridSize& grid, int reach)
  {
    for (int offset = -reach; offset <= reach; ++offset)
    {
      of_.push_back(scene.truth(grid, offset));
    }
  }

  int reach() const { return static_cast<int>(of_.size() / 2); }
  const Outcome& at(int offset) const { return of_[static_cast<std::size_t>(offset + reach())]; }

 private:
  std::vector<Outcome> of_;
};

class Runner
{
 public:
  Runner(Entry& entry, std::unique_ptr<MethodRun> run, const Truths& truths, int states_per_step)
      : entry_(entry), run_(std::move(run)), truths_(truths), states_per_step_(states_per_step)
  {
  }

  /// Evaluates the first result from a cold start, and some more. Returns the longest time of a result: a method that
  /// fails at once on the scene may take long at the next position.
  double warmUp()
  {
    const double start = now();
    double longest = timeOf(1, [this](int) { run_->solve(0); });
    int results = 1;
    for (int i = 0; i < warm_up && now() - start < warm_up_time; ++i)
    {
      longest = std::max(longest, timeOf(1, [this](int) { next(); }));
      ++results;
    }
    slow_ = now() - start > fast * results;
    return longest;
  }

  /// Warm results at all positions, to and fro.
  void visitWarm()
  {
    visit(entry_.warm, period(), [this](int) { return next(); });
  }

  /// Cold results at the position of the scene.
  void visitCold()
  {
    visit(entry_.cold, slow_ ? 1 : 4,
          [this](int)
          {
            run_->reset();
            run_->solve(0);
            return 0;
          });
  }

  /// Times each state of the path to and fro, in small steps and in those of the messages.
  void sweepWarm()
  {
    if (slow_ || sweep_time_ > enough_sweep_time)
    {
      return;
    }
    std::vector<double> times;
    for (const int per_step : {states_per_step_, 1})
    {
      const int last = 2 * truths_.reach() * per_step;
      const auto solve_state = [&](int k)
      { run_->solve(static_cast<double>(k <= last ? k : 2 * last - k) / per_step - truths_.reach()); };
      solve_state(0);
      for (int k = 1; k <= 2 * last; ++k)
      {
        times.push_back(timeOf(1, [&](int) { solve_state(k); }));
      }
    }
    sweep_time_ += std::accumulate(times.begin(), times.end(), 0.0);
    addSweep(times);
  }

 private:
  /// Number of messages of one cycle to and fro.
  int period() const { return 4 * truths_.reach(); }

  /// Adds the times of one round to those of the states.
  void addSweep(const std::vector<double>& times)
  {
    entry_.warm.sweep_times.resize(times.size());
    for (std::size_t k = 0; k < times.size(); ++k)
    {
      entry_.warm.sweep_times[k].push_back(times[k]);
    }
  }

  /// Solves the next message. Returns its offset: 1, 2 ... reach ... 0 ... -reach ... 0, again and again.
  int next()
  {
    const int reach = truths_.reach();
    const int along = (++messages_ + reach) % period();
    const int offset = along <= 2 * reach ? along - reach : 3 * reach - along;
    run_->solve(offset);
    return offset;
  }

  /// Times groups of messages; `message(i)` returns the offset. A group before them only fills the caches. The results
  /// of one group after them are inspected. Slow methods are inspected during timing, because the inspection takes
  /// little time in comparison.
  template <typename Message>
  void visit(Series& series, int group, Message message)
  {
    const double spent = group * std::accumulate(series.times.begin(), series.times.end(), 0.0);
    if (spent > enough_time && static_cast<std::size_t>(group) * series.times.size() >= few)
    {
      return;
    }
    const auto inspected = [&](int i) { inspect(series, message(i)); };
    if (slow_)
    {
      std::vector<double> times;
      times.reserve(static_cast<std::size_t>(group));
      for (int i = 0; i < group; ++i)
      {
        times.push_back(timeOf(1, inspected));
      }
      series.times.push_back(std::accumulate(times.begin(), times.end(), 0.0) / group);
      if (&series == &entry_.warm)
      {
        addSweep(times);
      }
      return;
    }
    timeOf(group, message);
    const double begin = now();
    do
    {
      series.times.push_back(timeOf(group, message));
    } while (now() - begin < visit_time);
    timeOf(group, inspected);
  }

  template <typename Message>
  static double timeOf(int group, Message message)
  {
    const double start = now();
    for (int i = 0; i < group; ++i)
    {
      message(i);
    }
    return (now() - start) / group;
  }

  /// Inspects the last result. The first position without a comparable result determines the status.
  void inspect(Series& series, int offset)
  {
    if (series.status != Series::Status::solved)
    {
      return;
    }
    const Outcome& truth = truths_.at(offset);
    series.outcome = run_->outcome();
    Errors errors;
    if (!series.outcome.usable)
    {
      series.status = Series::Status::refused;
      series.reason = series.outcome.reason;
    }
    else if (!compare(series.outcome, truth, errors))
    {
      series.status = Series::Status::other_wheels;
      series.reason = std::to_string(series.outcome.wheels.size()) +
                      " wheels have a contact, in the reference solution " + std::to_string(truth.wheels.size());
    }
    else
    {
      series.results.push_back({errors.largest(), series.outcome.estimate});
      series.errors = larger(series.errors, errors);
    }
  }

  Entry& entry_;
  std::unique_ptr<MethodRun> run_;
  const Truths& truths_;
  int states_per_step_;    ///< of the sweep
  int messages_ = 0;       ///< messages so far
  double sweep_time_ = 0;  ///< of all sweeps so far [s]
  bool slow_ = false;
};

/// Error of the reference solutions: their largest difference from those on a coarser grid [-].
double errorOf(const Truths& truths, const Truths& coarser, const std::string& scene)
{
  Errors largest;
  for (int offset = -truths.reach(); offset <= truths.reach(); ++offset)
  {
    const Outcome& truth = truths.at(offset);
    Errors own;
    if (!truth.usable || !compare(coarser.at(offset), truth, own))
    {
      throw std::runtime_error("no reference solution for " + scene + ", " + std::to_string(offset) +
                               " steps from it: " + truth.reason + " " + coarser.at(offset).reason);
    }
    largest = larger(largest, own);
  }
  return largest.largest();
}

/// Expected time of a sweep method on a grid, from its time on the previous one. It increases with the square of the
/// number of cells.
double expectedTime(const GridSize& before, double time, const GridSize& grid)
{
  const double ratio = static_cast<double>(grid.along * grid.across) / (before.along * before.across);
  return time * ratio * ratio;
}

using Visit = void (Runner::*)();

std::vector<Visit> visitsOf(const Plan& plan)
{
  std::vector<Visit> visits{&Runner::visitWarm, &Runner::visitCold};
  if (plan.sweeps)
  {
    visits.push_back(&Runner::sweepWarm);
  }
  return visits;
}

Entry notRun(const Choice& choice, double expected)
{
  Series series;
  series.status = Series::Status::not_run;
  series.reason = "expected to take too long";
  series.times = {expected};
  return {choice, series, series};
}

/// Creates the runs of all methods whose expected time is not too long.
std::vector<std::unique_ptr<Runner>> makeRunners(Scene& scene, const Plan& plan, const Truths& truths, Result& result)
{
  std::vector<std::unique_ptr<Runner>> runners;
  const Entry* before = nullptr;
  double before_time = 0;
  for (Entry& entry : result.entries)
  {
    const Choice& choice = entry.choice;
    if (choice.isSeidel() && before != nullptr && before->choice.method == choice.method)
    {
      const double expected = expectedTime(before->choice.grid, before_time, choice.grid);
      if (expected > plan.slowest)
      {
        entry = notRun(choice, expected);
        continue;
      }
    }
    runners.push_back(std::make_unique<Runner>(entry, scene.makeRun(choice), truths, scene.statesPerStep()));
    before_time = runners.back()->warmUp();
    before = &entry;
  }
  return runners;
}
}  // namespace

double Series::estimate() const
{
  const auto less = [](const Result& one, const Result& other) { return one.error < other.error; };
  const auto worst = std::max_element(results.rbegin(), results.rend(), less);  // the last of equal ones
  return worst != results.rend() ? worst->estimate : 0;
}

double Series::longest() const
{
  double longest = 0;
  for (const std::vector<double>& state : sweep_times)
  {
    longest = std::max(longest, quantile(state, 0.5));
  }
  return longest;
}

const char* toString(Series::Status status)
{
  switch (status)
  {
    case Series::Status::solved:
      return "solved";
    case Series::Status::refused:
      return "refused";
    case Series::Status::other_wheels:
      return "other_wheels";
    default:
      return "not_run";
  }
}

int stepsOf(const Plan& plan)
{
  return 2 + static_cast<int>(visitsOf(plan).size()) * plan.rounds;
}

Result compare(Scene& scene, const std::vector<Choice>& choices, const Plan& plan,
               const std::function<void()>& progress)
{
  Result result;
  const Truths truths(scene, plan.truth, plan.reach);
  result.truth_error = errorOf(truths, Truths(scene, plan.coarser, plan.reach), scene.name());
  progress();
  for (const Choice& choice : choices)
  {
    result.entries.push_back({choice, {}, {}});
  }
  const auto runners = makeRunners(scene, plan, truths, result);
  progress();
  for (const auto visit : visitsOf(plan))
  {
    for (int round = 0; round < plan.rounds; ++round)
    {
      for (const auto& runner : runners)
      {
        (*runner.*visit)();
      }
      progress();
    }
  }
  return result;
}
}  // namespace wheel_rail_contact::core::chart
