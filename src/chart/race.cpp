// SPDX-License-Identifier: BSD-3-Clause
#include "race.h"

#include <algorithm>
#include <ctime>
#include <numeric>
#include <stdexcept>

namespace wheel_rail_contact::chart
{
namespace
{
constexpr int settling = 8;             ///< messages before any is timed
constexpr int settling_automatic = 48;  ///< the same for auto, which tries coarser grids
constexpr double settling_time = 0.1;   ///< at most [s]
constexpr double fast = 5e-3;           ///< answers that take longer are not repeated within a visit [s]
constexpr double visit_time = 1e-3;     ///< [s]
constexpr double enough_time = 0.1;     ///< after so much, few samples will do [s]
constexpr std::size_t few = 3;

/// CPU time of this thread [s]: what else runs on the machine does not count.
double now()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

class Runner
{
 public:
  Runner(Entry& entry, std::unique_ptr<Contender> contender, const Outcome& truth)
      : entry_(entry), contender_(std::move(contender)), truth_(truth)
  {
  }

  /// The first answer, cold, and some more. Returns the time of the first.
  double settle()
  {
    const double start = now();
    contender_->answer(0);
    const double first = now() - start;
    slow_ = first > fast;
    const int messages = entry_.choice.isAutomatic() ? settling_automatic : settling;
    for (int i = 0; i < messages && now() - start < settling_time; ++i)
    {
      contender_->answer(offset(i));
    }
    return first;
  }

  /// Messages +1, 0, -1, 0 steps from the scene, again and again.
  void visitWarm()
  {
    visit(entry_.warm, slow_ ? 2 : 4, [this](int i) { contender_->answer(offset(i)); });
  }

  void visitCold()
  {
    visit(entry_.cold, slow_ ? 1 : 4,
          [this](int)
          {
            contender_->forget();
            contender_->answer(0);
          });
  }

 private:
  static int offset(int message)
  {
    constexpr int offsets[] = {1, 0, -1, 0};
    return offsets[message % 4];
  }

  /// Times groups of messages, which end at the scene. A group before them only fills the caches.
  template <typename Message>
  void visit(Series& series, int group, Message message)
  {
    const double spent = group * std::accumulate(series.times.begin(), series.times.end(), 0.0);
    if (spent > enough_time && series.times.size() >= few)
    {
      return;
    }
    if (!slow_)
    {
      timeOf(group, message);
    }
    const double begin = now();
    do
    {
      series.times.push_back(timeOf(group, message));
      inspect(series);
    } while (!slow_ && now() - begin < visit_time);
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

  void inspect(Series& series)
  {
    series.outcome = contender_->outcome();
    Errors errors;
    if (!series.outcome.usable)
    {
      series.status = Series::Status::refused;
      series.reason = series.outcome.reason;
    }
    else if (!compare(series.outcome, truth_, errors))
    {
      series.status = Series::Status::other_patches;
      series.reason = std::to_string(series.outcome.patches.size()) + " patches, the truth has " +
                      std::to_string(truth_.patches.size());
    }
    else
    {
      series.errors = larger(series.errors, errors);
    }
  }

  Entry& entry_;
  std::unique_ptr<Contender> contender_;
  const Outcome& truth_;
  bool slow_ = false;
};

/// Time from cold that a sweep method will take on a grid, from what it took on the one before: every cell acts on
/// every other.
double expectedTime(const GridSize& before, double time, const GridSize& grid)
{
  const double ratio = static_cast<double>(grid.along * grid.across) / (before.along * before.across);
  return time * ratio * ratio;
}

Entry notRun(const Choice& choice, double expected)
{
  Series series;
  series.status = Series::Status::not_run;
  series.reason = "expected to take too long";
  series.times = {expected};
  return {choice, series, series};
}

/// Sets up all contenders that will not take too long.
std::vector<std::unique_ptr<Runner>> setOut(Scene& scene, const Plan& plan, const Outcome& truth, Result& result)
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
    runners.push_back(std::make_unique<Runner>(entry, scene.contender(choice), truth));
    before_time = runners.back()->settle();
    before = &entry;
  }
  return runners;
}
}  // namespace

const char* toString(Series::Status status)
{
  switch (status)
  {
    case Series::Status::answered:
      return "answered";
    case Series::Status::refused:
      return "refused";
    case Series::Status::other_patches:
      return "other_patches";
    default:
      return "not_run";
  }
}

int stepsOf(const Plan& plan)
{
  return 2 + 2 * plan.rounds;
}

Result race(Scene& scene, const std::vector<Choice>& choices, const Plan& plan, const std::function<void()>& progress)
{
  Result result;
  const Outcome truth = scene.truth(plan.truth);
  Errors own;
  if (!truth.usable || !compare(scene.truth(plan.coarser), truth, own))
  {
    throw std::runtime_error("no truth for " + scene.name() + ": " + truth.reason);
  }
  result.truth_error = own.largest();
  progress();
  for (const Choice& choice : choices)
  {
    result.entries.push_back({choice, {}, {}});
  }
  const auto runners = setOut(scene, plan, truth, result);
  progress();
  for (const auto visit : {&Runner::visitWarm, &Runner::visitCold})
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
}  // namespace wheel_rail_contact::chart
