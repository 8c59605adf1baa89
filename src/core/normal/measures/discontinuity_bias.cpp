// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "core/normal/measures/gap_steps.h"
#include "core/normal/measures/pressure_measures.h"

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Index;

/// Inputs for curvature discontinuities near an edge crossing: steps of the SecondDifference of the gap, over the
/// pressure that scales EdgeInputs, in the row of the crossing. The first is the step between the columns three and two
/// inward of the loaded cell; the last is the step from the loaded cell to the next column outward. Outward is away
/// from the pressure; on a line along x, towards the line with less pressure. The steps are limited to ±3 and zero
/// where a body ends.
constexpr int edge_steps = 4;
using EdgeSteps = Eigen::Array<float, edge_steps, 1>;

/// The networks. Their output is the correction of the area [cells].
using Network = ReluNetwork<edge_inputs + edge_steps, 8>;

/// Limit for the steps, which are relative to the pressures at the crossing. These pressures vanish at the tips.
constexpr float step_limit = 3;

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

/// Output of test/calibration/fit_discontinuity_bias.cpp in revision e6707df: for lines of cells along x, and along y.
// clang-format off
constexpr std::array<double, 2 * Network::numbers> fitted_step{
    0.3342, -0.01587, 0.2171, -0.02907, -0.7441, 0.07427, 0.8776, 1.414, 0.1392, -0.6416, -0.6746, 0.3144,
    -0.3803, 0.1383, 0.6822, -0.07073, -0.618, -0.09891, -0.5699, -0.1954, -0.4894, -0.09663, -0.04966, 0.1357,
    0.1213, 0.627, -0.6049, 0.4348, -0.1586, 0.3757, 0.2341, 0.2465, -0.0574, 0.7248, 0.05744, 0.2,
    -0.6877, -0.0397, -0.1274, -0.04541, 0.1615, 0.3069, -0.2069, 0.5468, 0.8064, 0.09431, -0.3747, -0.2136,
    -0.3017, -0.3854, -0.5144, 0.3909, 0.408, 0.3845, -0.9004, 0.7347, -0.06155, 0.8458, 0.03877, 0.6453,
    0.9852, 0.519, 0.667, 0.4275, -0.1796, 0.3906, 0.7388, 0.5222, 0.8008, -0.8338, -1.841, 0.3548,
    -0.1797, 0.1772, 1.086, 0.06537, 0.4586, -0.7574, -0.4571, -0.09483, -0.4498, 0.8052, -0.3676, -0.4343,
    -0.537, 0.7585, 0.7266, 0.198, 0.07705, -0.1169, 0.03258, 0.4201, 0.272, -0.6091, -0.5799, 0.1307,
    0.006315, -0.2613, 0.4368, 0.2254, 0.1927, 0.6506, -0.08188, -0.8801, -0.6261, -0.04436, 0.2094, -0.008604,
    0.1342, -0.5477, 0.2435, 0.2458, -0.3956, 0.07784, 0.1805, 0.01389, -0.3866, 0.5058, 0.1162, -0.2237,
    -0.7715, 0.4913, 0.7484, -0.02502, -0.03917, -0.542, -0.03597, 0.7531, -0.37, -0.1719, -0.2007, 0.01903,
    0.5805, 0.2093, -0.04423, -0.06641, -0.103, 0.2189, -0.2984, -0.000816, 0.1243, 0.1784, 0.7468, 0.1335,
    0.1955, -0.0701, -0.2799, 0.5593, 0.4916, 0.3575, -0.1514, 0.6266, -0.1615, 0.1252, -0.5492, -0.1212,
    0.4032, 0.02321, -0.06018, 0.02474, -0.05917, -0.8601, 0.02694, 1.186, 0.3341, 0.3878, -0.3314, 1.277,
    0.359, -0.05165, 0.3071, -0.4915, -0.5009, -0.1839, -0.6628, -0.6263, -0.1064, -0.1276, 0.3068, -0.4887,
    0.7664, -0.6559, 0.2395, -0.09216, -0.2591, -0.06798, -0.5272, -0.01722, 0.4214, 0.6614, 0.2184, 0.7447,
    0.9673, -0.6858, -0.001719, -0.02465, -0.2056, -1.117, -0.9503, -0.02171, 0.15, 0.4663, 0.4612, -0.602,
    -1.004, -0.153, -0.4086, 0.04948, -0.5553, -0.09382, 0.1758, -0.3914, 0.5413, -0.4839, -0.9782, 0.2242,
    -0.4022, 0.2728, -0.5334, -0.08368, 0.1717, 0.08397, -0.185, 1.064, 0.3268, -0.3296, 0.4707, -0.3056,
    -0.2727, -0.4867, -1.187, -0.3162, 0.04237, -0.359, -0.583, 0.362, 0.1823, 0.4528, -0.6096, -0.2872,
    0.5077, 0.1932, -0.2802, -0.8507, -0.3304, 0.4957, 0.6101, -0.7241, 0.3649, -0.005109, 0.1046, 0.01223,
    -0.6062, 0.624, -0.5131, 0.1513, -0.01878, 0.4287, -0.19, -0.2297, -0.6947, 0.1399, -0.7469, 0.03942,
    0.2399, -0.1112, 0.3188, -0.2982, -0.134, 0.4289, -0.3622, -0.315, -0.1802, -0.4227, 0.5417, 0.1222,
    -0.4068, 0.3965, -0.423, -0.7298, 0.2213, 0.994, -0.5851, -0.3487, 0.2426, 0.2879, 0.1785, 0.6254,
    -1.022, 0.1817, -0.3012, -0.07903, -0.1592, 0.5003, 0.1849, 0.2326, 0.1155, -0.1871, -0.1721, 0.4044,
    0.1306, 0.1722, 0.7424, 0.1725, 0.1551, 0.1806, 0.2677, -0.01832, 0.08502, 0.1221, -0.1079, -0.2939,
    0.08502, 0.08771, -0.01356, -0.1184, -0.4964, -0.213, 0.07002, 0.05594, 0.1732, -0.0808,
};
// clang-format on

/// Columns near which the curvature of the gap may jump, determined from the middle row. None if `first` exceeds
/// `last`.
struct DiscontinuityColumns
{
  Index first, last = -1;

  explicit DiscontinuityColumns(const EdgeOf& edge) : first(edge.gap.gap.cols())
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
};

/// Finds the steps at a crossing. False if all of them are smooth, or if neither side is outward.
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
    steps[k] = known ? std::clamp(static_cast<float>(scale * step), -step_limit, step_limit) : 0;
    before = here;
  }
  return any;
}

/// Bias at a crossing [cells]: the output of the network minus that with all steps zero.
float biasAt(const EdgeCrossing& crossing, const EdgeInputs& shown, const EdgeSteps& steps)
{
  static const Network along(fitted_step.data()), across(fitted_step.data() + Network::numbers);
  const Network& network = crossing.along ? along : across;
  const Network::Sums without = network.hidden(shown);
  Network::Sums with = without;
  for (int k = 0; k < edge_steps; ++k)
  {
    with += network.slopes().col(edge_inputs + k) * steps[k];
  }
  return (network.linear().tail<edge_steps>() * steps).sum() +
         (network.heights() * (with.max(0.0F) - without.max(0.0F))).sum();
}
}  // namespace

DiscontinuitySums sumAtDiscontinuities(const EdgeOf& edge)
{
  const DiscontinuityColumns columns(edge);
  DiscontinuitySums sums;
  EdgeSteps steps;
  for (std::size_t k = 0; k < edge.polygon.crossings().size() && columns.first <= columns.last; ++k)
  {
    const EdgeCrossing& crossing = edge.polygon.crossings()[k];
    const EdgeInputs& inputs = edge.polygon.inputs()[k];
    const Index column = edge.polygon.loadedCell(crossing).column;
    if (column >= columns.first && column <= columns.last && findEdgeSteps(edge, crossing, inputs, steps))
    {
      const auto bias = static_cast<double>(biasAt(crossing, inputs, steps));
      sums.bias += bias;
      sums.sizes += std::abs(bias);
    }
  }
  return sums;
}
}  // namespace wheel_rail_contact::core
