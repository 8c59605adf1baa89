// SPDX-License-Identifier: BSD-3-Clause
#include "joint_excess.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
using Eigen::Index;

/// Steps of the contact's highest pressure that are smooth.
constexpr double least_step = 0.01;
/// Second differences of more, over that, are the end of a body; those of joints are below 3.
constexpr double no_surface = 5;
/// Steps over the pressures at the crossing count up to that: these go to nothing at tips.
constexpr float largest_step = 3;

/// Which way along y leads off the contact.
int outwardAcross(const EdgeCrossing& crossing)
{
  if (!crossing.along)
  {
    return crossing.outward > 0 ? 1 : -1;
  }
  const double* p = crossing.loaded;
  const double left = p[-crossing.sideways] + p[-crossing.sideways - crossing.outward];
  const double right = p[crossing.sideways] + p[crossing.sideways - crossing.outward];
  return right <= left ? 1 : -1;
}

/// The gap's second difference across, as a pressure [Pa]; NaN at the grid's border and where a body ends.
struct SecondDifference
{
  const Eigen::ArrayXXd& gap;
  double as_pressure, highest;  ///< E* / dy [Pa/m]; of a body [Pa]

  explicit SecondDifference(const EdgeOf& edge)
      : gap(edge.gap.gap), as_pressure(edge.modulus / edge.gap.grid.dy), highest(no_surface * edge.max_pressure)
  {
  }
  double at(Index row, Index column) const
  {
    if (column < 1 || column + 1 >= gap.cols())
    {
      return NAN;
    }
    const double here = as_pressure * (gap(row, column + 1) - 2 * gap(row, column) + gap(row, column - 1));
    return std::abs(here) < highest ? here : NAN;
  }
};
}  // namespace

JointColumns::JointColumns(const EdgeOf& edge) : first(edge.gap.gap.cols())
{
  // Under yaw another row's joints are a little aside, and its steps may be larger.
  constexpr Index aside = 1;
  constexpr double smaller = 0.5;
  const SecondDifference second(edge);
  const Index row = edge.gap.grid.symmetric ? 0 : edge.gap.gap.rows() / 2;
  const double smooth = smaller * least_step * edge.max_pressure;
  double before = NAN;
  for (Index j = 1; j + 1 < edge.gap.gap.cols(); ++j)
  {
    const double here = second.at(row, j);
    if (std::abs(here - before) > smooth)
    {
      first = std::min(first, j - edge_steps - aside);
      last = j + edge_steps + aside;
    }
    before = here;
  }
}

bool findEdgeSteps(const EdgeOf& edge, const EdgeCrossing& crossing, const EdgeInputs& inputs, EdgeSteps& steps)
{
  const auto [row, column] = edge.polygon.loadedCell(crossing);
  const int outward = outwardAcross(crossing);
  const SecondDifference second(edge);
  const double scale = static_cast<double>(inputs[0]) / *crossing.loaded, smooth = least_step * edge.max_pressure;
  bool any = false;
  double before = second.at(row, column - outward * (edge_steps - 1));
  for (int k = 0; k < edge_steps; ++k)
  {
    const double here = second.at(row, column + outward * (k + 2 - edge_steps)), step = here - before;
    const bool known = !std::isnan(step);
    any = any || (known && std::abs(step) > smooth);
    steps[k] = known ? std::clamp(static_cast<float>(scale * step), -largest_step, largest_step) : 0;
    before = here;
  }
  return any;
}

float JointExcess::at(const EdgeCrossing& crossing, const EdgeInputs& shown, const EdgeSteps& steps) const
{
  using Ramps = Eigen::Array<float, ramps, 1>;
  const Crossing& sum = crossing.along ? along : across;
  const auto slopes = sum.slopes();
  Ramps without = slopes.col(0) * shown[0];
  for (int k = 1; k < edge_inputs; ++k)
  {
    without += slopes.col(k) * shown[k];
  }
  Ramps with = without;
  for (int k = 0; k < edge_steps; ++k)
  {
    with += slopes.col(edge_inputs + k) * steps[k];
  }
  return (sum.linear().tail<edge_steps>() * steps).sum() + (sum.heights() * (with.max(0.0F) - without.max(0.0F))).sum();
}

JointSums sumAtJoints(const EdgeOf& edge)
{
  const JointExcess& known = jointExcess();
  JointSums sums;
  visitEdgeJoints(edge,
                  [&](const EdgeCrossing& crossing, const EdgeInputs& inputs, const EdgeSteps& steps)
                  {
                    const auto excess = static_cast<double>(known.at(crossing, inputs, steps));
                    sums.excess += excess;
                    sums.sizes += std::abs(excess);
                  });
  return sums;
}
}  // namespace wheel_rail_contact
