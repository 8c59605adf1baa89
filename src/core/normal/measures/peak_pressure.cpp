// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/peak_pressure.h"

#include <algorithm>
#include <cmath>

#include "core/normal/measures/peak_bias.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Share of the bend that an excess reaches at most. Of wheelsets on the grids of `auto` it is up to 0.05, of contacts
/// on one or two rows of cells 0.07.
constexpr double most_of_bend = 0.1;
}  // namespace

double crestPressure(const PatchGap& gap, double modulus, const CellsAround& crest)
{
  if (!crest.isInside())
  {
    return crest.top();
  }
  const GapSteps steps = gapSteps(crest, gap, modulus);
  if (!showsExcess(crest, steps))
  {
    return crest.parabolas();
  }
  const double most = most_of_bend * crest.bend();
  const double excess = crestExcess().of(CrestInputs(crest, steps, std::log(gap.grid.dx / gap.grid.dy)));
  return crest.parabolas() / (1 + std::clamp(excess, -most, most));
}
}  // namespace wheel_rail_contact::core
