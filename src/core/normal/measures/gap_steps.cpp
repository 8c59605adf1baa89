// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/gap_steps.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Index;

/// Jump of the curvature of the gap.
struct Jump
{
  double place = 0;  ///< position, counted from the first step [cells]
  double size = 0;   ///< jump of the second difference, in the unit of GapSteps
};

struct Jumps
{
  std::array<Jump, std::tuple_size<GapSteps>::value> list;
  std::size_t count = 0;

  const Jump* begin() const { return list.data(); }
  const Jump* end() const { return list.data() + count; }
};

/// Steps minus the part that they share with the steps two columns away on either side, which belongs to a curvature
/// that changes smoothly. Zero for the two steps at each end.
GapSteps besideSmooth(const GapSteps& steps)
{
  GapSteps sharp{};
  for (std::size_t k = 2; k + 2 < steps.size(); ++k)
  {
    const bool smooth = steps[k - 2] * steps[k] > 0 && steps[k + 2] * steps[k] > 0;
    const double shared = smooth ? std::min(std::abs(steps[k - 2]), std::abs(steps[k + 2])) : 0;
    sharp[k] = std::copysign(std::max(std::abs(steps[k]) - shared, 0.0), steps[k]);
  }
  return sharp;
}

/// Combines the largest step and its neighbours of the same sign to one jump, then the largest of the remaining steps.
Jumps findJumps(GapSteps steps)
{
  Jumps found;
  const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
  for (;;)
  {
    const auto greatest = static_cast<std::size_t>(std::max_element(steps.begin(), steps.end(), less) - steps.begin());
    const double step = steps[greatest];
    if (!(std::abs(step) > smooth_step))
    {
      return found;
    }
    Jump jump;
    double moment = 0;
    for (std::size_t k = greatest - 1; k <= greatest + 1; ++k)
    {
      if (steps[k] * step > 0)
      {
        jump.size += steps[k];
        moment += steps[k] * static_cast<double>(k);
        steps[k] = 0;
      }
    }
    jump.place = moment / jump.size;
    found.list[found.count++] = jump;
  }
}

/// True if two jumps of opposite sign within a few cells are the flanks of a wave.
bool areWave(const Jump& one, const Jump& other)
{
  constexpr double near = 4, alike = 1.0 / 3;
  const double larger = std::max(std::abs(one.size), std::abs(other.size));
  return std::abs(one.place - other.place) < near && one.size * other.size < -alike * larger * larger;
}
}  // namespace

GapSteps gapSteps(const CellsAround& peak, const PatchGap& gap, double modulus)
{
  const SecondDifference second(gap, modulus, peak.top());
  GapSteps steps{};
  double before = NAN;
  for (Index offset = -steps_reach; offset <= steps_reach; ++offset)
  {
    const double here = peak.p(0, offset) > 0 ? second.at(peak.row(), peak.column() + offset) : NAN;
    const double step = here - before;
    if (offset > -steps_reach && !std::isnan(step))
    {
      steps[static_cast<std::size_t>(offset - 1 + steps_reach)] = step;
    }
    before = here;
  }
  return steps;
}

bool areWaves(const GapSteps& steps)
{
  const Jumps found = findJumps(besideSmooth(steps));
  return std::any_of(
      found.begin(), found.end(),
      [&](const Jump& one)
      { return std::any_of(found.begin(), found.end(), [&one](const Jump& other) { return areWave(one, other); }); });
}
}  // namespace wheel_rail_contact::core
