// SPDX-License-Identifier: BSD-3-Clause
// Compares the cost of `method: auto`, which chooses a grid, with that of the cheapest fixed method and grid, on random
// wheelsets. Each is solved by
// every fixed method on every grid, and by `auto` at 10, 3, 1 and 0.3 %.
//
//   verify_grid_choice [scenes, default 260] [seed, default 92]
//
// Warm times are those of messages 0.05 mm apart, moving back and forth around the scene. Cold times are those of
// results without a previous one. All are CPU times of the thread (src/chart/comparison.cpp). The reference is a
// solution by conjugate gradients on 256 × 512 cells.
//
// Prints for each tolerance:
// * the number of scenes in which all results met it;
// * of the others, the number in which the estimate of the worst result was above it;
// * the number in which the largest true error was within the estimate of that result;
// * the shares of all results that met it, or else had an estimate above it;
// * the time over that of the cheapest fixed method that is converged to the tolerance and whose true error meets it:
//   median, 25, 75 and 90 % quantiles over the scenes.
// Seidel is left out, because it is never the cheapest. Takes some minutes; not part of the test run.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include "../core/normal/error_samples.h"
#include "chart/comparison.h"
#include "chart/quantile.h"
#include "chart/wheelset_scene.h"

namespace
{
using namespace wheel_rail_contact::core;

bool meets(const chart::Series& series, double tolerance)
{
  return series.status == chart::Series::Status::solved && series.errors.largest() <= tolerance;
}

/// Time of the cheapest fixed method that is converged to the tolerance and meets it [s]; infinite if none does.
double cheapest(const chart::Result& result, chart::Series chart::Entry::*start, double tolerance)
{
  double least = std::numeric_limits<double>::infinity();
  for (const chart::Entry& entry : result.entries)
  {
    if (!entry.choice.isAutomatic() && entry.choice.tolerance == tolerance && meets(entry.*start, tolerance))
    {
      least = std::min(least, chart::quantile((entry.*start).times, 0.5));
    }
  }
  return least;
}

/// Results of `auto` at one tolerance, warm or cold.
struct Tally
{
  int scenes = 0, met = 0, flagged = 0, held = 0;
  std::size_t results = 0, results_met = 0, results_flagged = 0;
  std::vector<double> times;   ///< median times of a result [s]
  std::vector<double> ratios;  ///< over the time of the cheapest fixed method, where one meets the tolerance [-]

  void count(const chart::Series& series, double tolerance, double cheapest_time)
  {
    if (series.status != chart::Series::Status::solved)
    {
      return;
    }
    const bool within = meets(series, tolerance);
    const double time = chart::quantile(series.times, 0.5);
    ++scenes;
    met += within ? 1 : 0;
    flagged += !within && series.estimate() > tolerance ? 1 : 0;
    held += series.errors.largest() <= series.estimate() ? 1 : 0;
    for (const chart::Series::Result& result : series.results)
    {
      ++results;
      results_met += result.error <= tolerance ? 1 : 0;
      results_flagged += result.error > tolerance && result.estimate > tolerance ? 1 : 0;
    }
    times.push_back(time);
    if (cheapest_time < std::numeric_limits<double>::infinity())
    {
      ratios.push_back(time / cheapest_time);
    }
  }

  void print(const char* start, double tolerance) const
  {
    const double percent = 100 / static_cast<double>(results);
    std::printf("%s %8.1f %% %7d %6d %8d %6d | %7zu %6.2f %% %7.2f %% | %8.3f ms | %8zu %7.2f %7.2f %7.2f %7.2f\n",
                start, 100 * tolerance, scenes, met, flagged, held, results, percent * static_cast<double>(results_met),
                percent * static_cast<double>(results_flagged), 1e3 * chart::quantile(times, 0.5), ratios.size(),
                chart::quantile(ratios, 0.5), chart::quantile(ratios, 0.25), chart::quantile(ratios, 0.75),
                chart::quantile(ratios, 0.9));
  }
};

/// `auto`, and the fixed methods at each tolerance, to which their balance is converged as well. Hertz and
/// Kik–Piotrowski are on the coarsest grid only, because their errors do not decrease with the cells.
std::vector<chart::Choice> choices()
{
  std::vector<chart::Choice> list;
  for (const chart::Choice& choice : chart::allChoices())
  {
    const bool finer = choice.grid.along * choice.grid.across > 8 * 16;
    const bool shape = choice.method == NormalMethod::hertz || choice.method == NormalMethod::kik_piotrowski;
    if (choice.isAutomatic())
    {
      list.push_back(choice);
    }
    else if (!choice.isSeidel() && !(shape && finer))
    {
      std::transform(chart::tolerances.begin(), chart::tolerances.end(), std::back_inserter(list),
                     [&](double tolerance) {
                       return chart::Choice{choice.method, choice.grid, tolerance};
                     });
    }
  }
  return list;
}

struct Tallies
{
  std::map<double, Tally> warm, cold;  ///< by tolerance

  void count(const chart::Result& result)
  {
    for (const chart::Entry& entry : result.entries)
    {
      const double tolerance = entry.choice.tolerance;
      if (entry.choice.isAutomatic())
      {
        warm[tolerance].count(entry.warm, tolerance, cheapest(result, &chart::Entry::warm, tolerance));
        cold[tolerance].count(entry.cold, tolerance, cheapest(result, &chart::Entry::cold, tolerance));
      }
    }
  }

  void print() const
  {
    std::printf(
        "start tolerance   scenes    met  flagged   held | results    met   flagged | median time | compared "
        " median    25 %%    75 %%    90 %%\n");
    for (const auto& [tolerance, tally] : warm)
    {
      tally.print("warm", tolerance);
    }
    for (const auto& [tolerance, tally] : cold)
    {
      tally.print("cold", tolerance);
    }
  }
};
}  // namespace

int main(int argc, char** argv)
{
  const int count = argc > 1 ? std::atoi(argv[1]) : 260;
  const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 92;
  if (count < 1 || argc > 3)
  {
    std::fprintf(stderr, "usage: verify_grid_choice [SCENES [SEED]]\n");
    return 2;
  }
  chart::Plan plan;
  plan.sweeps = false;
  plan.rounds = 2;
  plan.reach = 1;  // many scenes, each at its own position: results that are right by chance have little weight
  const std::vector<chart::Choice> all = choices();
  const auto solver_cache = std::make_shared<chart::SolverCache>();
  Tallies tallies;
  int without_truth = 0;
  scenes::Random seeds(seed);
  for (int i = 0; i < count; ++i)
  {
    scenes::Random random(seeds());
    const scenes::WheelsetScene drawn = scenes::randomWheelsetScene(random);
    chart::WheelsetScene scene("random", "random", std::make_shared<chart::WheelsetPool>(drawn.config), solver_cache,
                               drawn.state);
    try
    {
      tallies.count(chart::compare(scene, all, plan, [] {}));
    }
    catch (const std::runtime_error&)
    {
      ++without_truth;
    }
    std::fprintf(stderr, "\rscene %d of %d", i + 1, count);
  }
  std::fprintf(stderr, "\n");
  std::printf("seed %lu, %d scenes, %d of them without a reference\n", seed, count, without_truth);
  tallies.print();
  return 0;
}
