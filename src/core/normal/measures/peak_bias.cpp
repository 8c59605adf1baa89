// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/peak_bias.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Index;

/// Network inputs at the end of the line along the track through the peak, in the `outward` direction (+1 or -1).
EdgeInputs tipInputs(const CellsAround& peak, Index outward, double longer)
{
  const Index tip = peak.tip(outward);
  // Three neighbouring lines, each from the empty cell inward.
  constexpr int line = 4;
  std::array<double, static_cast<std::size_t>(3 * line)> cells;
  for (int k = 0; k < line; ++k)
  {
    for (int side = 0; side < 3; ++side)
    {
      cells[static_cast<std::size_t>(side * line + k)] = peak.p(tip + (1 - k) * outward, side - 1);
    }
  }
  return edgeInputs({cells.data() + line + 1, -1, line, true}, longer);
}

PeakInputs::Side sideInputs(const CellsAround& peak, const GapSteps& steps, int direction)
{
  PeakInputs::Side inputs;
  Index k = 0;
  for (int offset = -peak_reach; offset <= peak_reach; ++offset)
  {
    if (offset != 0)
    {
      inputs[k++] = static_cast<float>(1 - std::min(peak.p(0, direction * offset), 1.0));
    }
  }
  double squares = 0;
  for (int offset = -peak_reach; offset < peak_reach; ++offset)
  {
    const int from = direction > 0 ? offset : -1 - offset;
    const double step = std::clamp(steps[static_cast<std::size_t>(from + steps_reach)], -largest_step, largest_step);
    inputs[k++] = static_cast<float>(direction * step);
    squares += step * step;
  }
  const double before = peak.p(-1, 0), after = peak.p(1, 0);
  inputs[k++] = static_cast<float>(1 - 0.5 * (before + after));
  inputs[k++] = static_cast<float>(0.5 * std::abs(before - after));
  inputs[k++] = static_cast<float>(std::sqrt(squares));
  return inputs;
}
}  // namespace

PeakInputs::PeakInputs(const CellsAround& peak, const GapSteps& steps, double longer)
    : tips{tipInputs(peak, -1, longer), tipInputs(peak, 1, longer)},
      sides{sideInputs(peak, steps, 1), sideInputs(peak, steps, -1)},
      along(peak.bendAlong())
{
}

bool showsBias(const CellsAround& peak, const GapSteps& steps)
{
  return peak.isInside() && !areWaves(steps) && !peak.isCutAlong();
}

double PeakBias::of(const PeakInputs& inputs) const
{
  const float from_tips = tip(inputs.tips[0]) + tip(inputs.tips[1]);
  return inputs.along * static_cast<double>(from_tips) +
         static_cast<double>(side(inputs.sides[0]) + side(inputs.sides[1]));
}
}  // namespace wheel_rail_contact::core
