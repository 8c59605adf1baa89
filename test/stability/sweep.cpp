// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.h"

#include "../core/balance/wheelset_scene.h"
#include "core/balance/wheelset_balance.h"
#include "scene.h"
#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
SweepState solved(WheelsetBalance& balance, const WheelsetState& state)
{
  SweepState found;
  found.usable = isUsable(balance.solve(state));
  found.solutions = balance.solutions();
  found.height = balance.height();
  for (const Side side : sides)
  {
    found.lateral[side] = found.usable ? balance.wheel(side).contact().solved().forces()[rail_lateral] : 0;
  }
  return found;
}

ContactModelConfig withRadius(double radius)
{
  ContactModelConfig config = standard();
  config.wheelset.rolling_radius = radius;
  return config;
}

Verdict byLimits(double value, const std::vector<double>& limits, const std::vector<const char*>& texts)
{
  Verdict verdict = texts.back();
  for (std::size_t k = limits.size(); k-- > 0;)
  {
    verdict = Verdict::byLimit(value, limits[k], verdict, texts[k]);
  }
  return verdict;
}

Verdict range(const Sweep& sweep, const Loop& loop)
{
  if (loop.first > loop.last)
  {
    return "nowhere";
  }
  constexpr double unit = 0.02;  // [mm]
  return Verdict::rounded(1e3 * sweep.at(loop.first), unit)
      .with(Verdict::rounded(1e3 * sweep.at(loop.last), unit), "–")
      .with("mm", " ");
}
}  // namespace

int Sweep::steps() const
{
  return static_cast<int>(std::lround((end - begin) / step));
}

SweepResult run(const Sweep& sweep)
{
  const GridLevels levels(sweep.config);
  WheelsetBalance balance(sweep.config, levels);
  const int last = sweep.steps();
  SweepResult result;
  for (int k = 0; k <= last; ++k)
  {
    result.out.push_back(solved(balance, stateAt(sweep.at(k), sweep.wheel_load)));
  }
  for (int k = last; k >= 0; --k)
  {
    result.back.push_back(solved(balance, stateAt(sweep.at(k), sweep.wheel_load)));
  }
  std::reverse(result.back.begin(), result.back.end());
  return result;
}

int refused(const SweepResult& result)
{
  int count = 0;
  for (const auto* way : {&result.out, &result.back})
  {
    count += static_cast<int>(
        std::count_if(way->begin(), way->end(), [](const SweepState& state) { return !state.usable; }));
  }
  return count;
}

int mostSolutions(const SweepResult& result)
{
  int most = 0;
  for (const auto* way : {&result.out, &result.back})
  {
    for (const SweepState& state : *way)
    {
      most = std::max(most, state.solutions);
    }
  }
  return most;
}

double lateralStep(const SweepState& one, const SweepState& other)
{
  return std::max(std::abs(one.lateral.left - other.lateral.left), std::abs(one.lateral.right - other.lateral.right));
}

double largestStep(const std::vector<SweepState>& way)
{
  double largest = 0;
  for (std::size_t k = 1; k < way.size(); ++k)
  {
    largest = std::max(largest, lateralStep(way[k - 1], way[k]));
  }
  return largest;
}

Loop loopOf(const Sweep& sweep, const SweepResult& result)
{
  Loop loop{sweep.steps() + 1, -1};
  for (int k = 0; k <= sweep.steps(); ++k)
  {
    const auto at = static_cast<std::size_t>(k);
    if (lateralStep(result.out[at], result.back[at]) > jump * sweep.wheel_load)
    {
      loop = {std::min(loop.first, k), k};
    }
  }
  return loop;
}

std::vector<Sweep> sweeps()
{
  const ComplianceTable paper_rail{6.8559e-9, 6.4942e-8, 1.0477e-6, 2.4732e-10};  // config/rails/paper.yaml
  return {{"onset at the gauge corner, y = 4.3 to 4.6 mm", standard(), 1e5, 4.3e-3, 4.6e-3, 1e-6, false},
          {"flange root, y = 6 to 6.5 mm", standard(), 1e5, 6e-3, 6.5e-3, 5e-6, false},
          {"rolling radius 0.6 m, y = 6 to 6.5 mm", withRadius(0.6), 1e5, 6e-3, 6.5e-3, 5e-6, true},
          {"pads 40/100, 20 kN per wheel, y = 8.8 to 9.6 mm", standardOn(softPads()), 2e4, 8.8e-3, 9.6e-3, 5e-6, true},
          {"rail of the paper, y = 7.9 to 8.3 mm", standardOn(paper_rail), 1e5, 7.9e-3, 8.3e-3, 2e-6, true}};
}

MapTable sweepMap()
{
  MapTable table{
      "Sweeps",
      "The wheelsets of the first table move outward and back with `auto`, in steps of 1 to 5 µm. Each state starts "
      "from "
      "the result of the one before. Columns: states without a result; largest change of a lateral force from one "
      "state "
      "to the next, over the wheel load; largest number of normal problems for a state, of both wheels together; y at "
      "which the result depends on the direction. Two equilibria exist there, and both ways lead to one of them. At "
      "the ends of this range the wheelset jumps to the other one. Rigid rails and a rolling radius of 0.46 m leave "
      "only one equilibrium ([theory.md](theory.md#two-equilibria)). The table of the rail of the paper is "
      "`config/rails/paper.yaml`.",
      {"without a result", "largest step", "normal problems", "two results"},
      {}};
  for (const Sweep& sweep : sweeps())
  {
    const SweepResult result = run(sweep);
    const int without = refused(result);
    table.rows.push_back(
        {sweep.name,
         {without == 0 ? Verdict("none")
                       : Verdict((std::to_string(without) + " of " + std::to_string(2 * sweep.steps() + 2)).c_str()),
          byLimits(std::max(largestStep(result.out), largestStep(result.back)) / sweep.wheel_load, {1e-3, 1e-2, jump},
                   {"up to 0.1 %", "0.1–1 %", "1–10 %", "jump"}),
          byLimits(mostSolutions(result), {10, 20, 40, 80}, {"up to 10", "11–20", "21–40", "41–80", "more than 80"}),
          range(sweep, loopOf(sweep, result))}});
  }
  return table;
}
}  // namespace wheel_rail_contact::core::stability
