// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/peak_pressure.h"

#include <algorithm>
#include <cmath>

#include "core/normal/measures/peak_bias.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Largest bias, as a share of the bend. On wheelsets and the grids of `auto` it is up to 0.05, on contacts of one or
/// two rows of cells 0.07.
constexpr double most_of_bend = 0.1;
}  // namespace

double peakPressure(const PatchGap& gap, double modulus, const CellsAround& peak)
{
  if (!peak.isInside())
  {
    return peak.top();
  }
  const GapSteps steps = gapSteps(peak, gap, modulus);
  if (!showsBias(peak, steps))
  {
    return peak.parabolas();
  }
  const double most = most_of_bend * peak.bend();
  const double bias = peakBias().of(PeakInputs(peak, steps, std::log(gap.grid.dx / gap.grid.dy)));
  return peak.parabolas() / (1 + std::clamp(bias, -most, most));
}
}  // namespace wheel_rail_contact::core
