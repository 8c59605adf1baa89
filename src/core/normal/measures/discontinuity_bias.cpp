// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/discontinuity_bias.h"

#include <algorithm>
#include <cmath>

#include "core/normal/measures/second_difference.h"

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Index;

/// Limit for the steps, which are relative to the pressures at the crossing. These pressures vanish at the tips.
constexpr float largest_step = 3;

/// Direction along y that leads out of the contact; zero if the lines on both sides of a line along x carry the same
/// pressure.
int outwardAcross(const EdgeCrossing& crossing)
{
  if (!crossing.along)
  {
    return crossing.outward > 0 ? 1 : -1;
  }
  const double* p = crossing.loaded;
  const double left = p[-crossing.sideways] + p[-crossing.sideways - crossing.outward];
  const double right = p[crossing.sideways] + p[crossing.sideways - crossing.outward];
  return left == right ? 0 : right < left ? 1 : -1;
}
}  // namespace

DiscontinuityColumns::DiscontinuityColumns(const EdgeOf& edge) : first(edge.gap.gap.cols())
{
  // Under yaw, the discontinuities of other rows are slightly displaced, and their steps may be larger.
  constexpr Index aside = 1;
  constexpr double smooth = 0.5 * smooth_step;
  const SecondDifference second(edge.gap, edge.modulus, edge.max_pressure);
  const Index row = edge.gap.grid.symmetric ? 0 : edge.gap.gap.rows() / 2;
  double before = NAN;
  for (Index j = 1; j + 1 < edge.gap.gap.cols(); ++j)
  {
    const double here = second.at(row, j);
    if (std::abs(here - before) > smooth)
    {
      // Range of the loaded cells whose crossings have this step among their inputs.
      first = std::min(first, j + 1 - edge_steps - aside);
      last = j + edge_steps - 2 + aside;
    }
    before = here;
  }
}

bool findEdgeSteps(const EdgeOf& edge, const EdgeCrossing& crossing, const EdgeInputs& inputs, EdgeSteps& steps)
{
  const int outward = outwardAcross(crossing);
  if (outward == 0)
  {
    return false;
  }
  const SecondDifference second(edge.gap, edge.modulus, edge.max_pressure);
  const auto [row, column] = edge.polygon.loadedCell(crossing);
  const double scale = static_cast<double>(inputs[0]) / *crossing.loaded * edge.max_pressure;
  bool any = false;
  double before = second.at(row, column - outward * (edge_steps - 1));
  for (int k = 0; k < edge_steps; ++k)
  {
    const double here = second.at(row, column + outward * (k + 2 - edge_steps)), step = here - before;
    const bool known = !std::isnan(step);
    any = any || (known && std::abs(step) > smooth_step);
    steps[k] = known ? std::clamp(static_cast<float>(scale * step), -largest_step, largest_step) : 0;
    before = here;
  }
  return any;
}

float DiscontinuityBias::at(const EdgeCrossing& crossing, const EdgeInputs& shown, const EdgeSteps& steps) const
{
  using Units = Eigen::Array<float, units, 1>;
  const Crossing& sum = crossing.along ? along : across;
  const auto slopes = sum.slopes();
  Units without = slopes.col(0) * shown[0];
  for (int k = 1; k < edge_inputs; ++k)
  {
    without += slopes.col(k) * shown[k];
  }
  Units with = without;
  for (int k = 0; k < edge_steps; ++k)
  {
    with += slopes.col(edge_inputs + k) * steps[k];
  }
  return (sum.linear().tail<edge_steps>() * steps).sum() + (sum.heights() * (with.max(0.0F) - without.max(0.0F))).sum();
}

DiscontinuitySums sumAtDiscontinuities(const EdgeOf& edge)
{
  const DiscontinuityBias& known = discontinuityBias();
  DiscontinuitySums sums;
  visitEdgeDiscontinuities(edge,
                           [&](const EdgeCrossing& crossing, const EdgeInputs& inputs, const EdgeSteps& steps)
                           {
                             const auto bias = static_cast<double>(known.at(crossing, inputs, steps));
                             sums.bias += bias;
                             sums.sizes += std::abs(bias);
                           });
  return sums;
}
}  // namespace wheel_rail_contact::core
