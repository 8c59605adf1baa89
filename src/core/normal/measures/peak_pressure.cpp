// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "core/normal/measures/edge_bias.h"
#include "core/normal/measures/gap_steps.h"
#include "core/normal/measures/pressure_measures.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Largest bias, as a share of the bend. On wheelsets and the grids of `auto` it is up to 0.05, on contacts of one or
/// two rows of cells 0.07.
constexpr double most_of_bend = 0.1;

constexpr int peak_reach = 4;       ///< columns considered on either side of a peak
constexpr double largest_step = 2;  ///< limit of the GapSteps
constexpr int side_inputs = 19;

using Eigen::Index;
using TipNetwork = ReluNetwork<edge_inputs, 8>;
using SideNetwork = ReluNetwork<side_inputs, 16>;

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

/// Network inputs of the row of the peak, in the `direction` +1, or -1 with opposite sign of the steps:
/// * deficits of the pressures of peak_reach columns before and after the peak, relative to the peak (at least zero);
/// * GapSteps between these columns;
/// * deficit of the mean of the cells before and after the peak along the track, and half of their difference;
/// * root of the sum of the squared steps.
Eigen::Array<float, side_inputs, 1> sideInputs(const CellsAround& peak, const GapSteps& steps, int direction)
{
  Eigen::Array<float, side_inputs, 1> inputs;
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

/// Output of test/calibration/fit_peak_bias.cpp in revision e6707df: tip, side.
// clang-format off
constexpr std::array<double, TipNetwork::numbers + SideNetwork::numbers> fitted_peak{
    0.3848, 0.005758, -0.3478, -0.3372, -0.02053, -0.1462, 0.9373, 0.0719, 0.1971, -0.1463, -0.2607, 0.08396,
    -0.3971, -0.005732, 0.0643, -0.4704, -1.114, -0.01716, 0.2995, -0.6817, -1.051, -0.4116, -0.2241, -0.1639,
    0.8123, 0.1703, -1.038, -0.8112, -4.166, 0.008834, -0.4412, -0.3924, -0.09922, 0.6794, -0.4751, 0.1046,
    -0.0932, -0.5503, 0.4089, -0.1611, -0.2374, -0.5109, -0.3302, 0.6359, 0.6429, 0.2784, -0.2404, -0.1503,
    0.1588, -1.638, 0.2905, 0.06859, -0.04635, -0.02509, -0.1555, 1.152, 0.6155, 0.4395, -0.2921, -0.5703,
    -2.788, 0.1082, 0.2485, -0.1511, 0.07115, -0.2734, -1.412, 0.2829, 0.4742, -0.798, -0.01663, -0.0568,
    -1.024, 0.6374, 1.346, -1.147, 0.9837, 0.3978, 0.4793, 0.2636, -1.088, -1.157, -0.08241, -0.9877,
    -0.3584, 0.4993, -0.2686, 2.476, 0.004445, 0.06606, -0.01316, 0.1577, 0.5013, 0.005626, 0.03831, -0.0222,
    0.177, -0.1277, -0.2857, -0.06354, 0.3816, 0.6181, -0.2582, -0.6206, -0.1128, 0.0686, 0.03697, 0.04426,
    -0.04053, 0.06628, 0.03174, -0.03028, 0.004906, 0.0004067, 0.02459, -0.01418, 0.01709, -0.003471, 0.0002782, -0.01418,
    0.04672, -0.02994, -0.01686, 0.0005297, -0.04792, -0.003677, -8.961e-05, 0.003858, -0.00513, 0.003873, 0.002214, 0.0008489,
    -0.002578, -0.007623, 0.005783, 0.003283, -0.005695, -0.0008222, -0.009774, -0.0008204, 0.00593, 0.01325, 0.003212, -0.009561,
    -0.005179, -0.002276, -0.004539, -0.006657, -0.002682, -0.00648, -0.00204, -0.00431, -0.008651, -0.007169, -0.01124, 0.003095,
    -0.002411, -0.02118, -0.01147, 0.0244, -0.02386, -0.008506, -0.00184, 0.0003279, 0.01906, -0.006958, -0.02344, 0.003963,
    -0.01305, -0.03683, -0.03596, -0.001792, -0.001683, -0.0139, -0.04207, -0.04191, 0.09011, -0.005103, -0.04981, 0.02116,
    -0.03283, 0.02973, -0.03744, 0.02786, -0.07266, 0.01033, 0.1606, -0.01648, 0.009321, 0.08069, -0.01174, 0.01457,
    -0.01416, -0.2328, 0.03412, -0.1265, 0.01537, 0.02288, 0.04523, -0.176, 0.009913, -0.09434, 0.1098, 0.03524,
    0.01917, 0.006609, 0.01657, 0.0004003, 0.01348, -0.0263, -0.01312, 0.03976, -0.0237, 0.006689, 0.0007493, 0.004951,
    -0.008156, -0.02775, -0.027, 0.01591, 0.02035, -0.01051, 0.001648, -0.0044, -0.003147, -0.01236, 0.0003236, -0.0145,
    0.0003691, -0.008657, -0.006435, -0.003033, -0.002479, 0.01113, -0.01362, 0.005445, -0.01065, -0.004177, -0.002897, -0.001193,
    -4.337e-05, -0.005179, -0.002655, 0.004128, 0.001687, 0.0005822, -0.0003378, -0.00221, -0.007193, -3.291e-05, -0.004493, -0.0005257,
    -0.002229, -0.0226, 3.121e-05, 0.01363, 0.01691, -0.04168, -0.03377, 0.003928, 0.003276, -0.07193, 0.01248, -0.02208,
    0.03659, 0.005553, 0.01044, 0.0008086, -0.01536, -0.03486, 0.02943, 0.01693, 0.02458, 0.01445, -0.03413, -0.009009,
    0.003066, 0.02187, 0.009544, -0.01111, 0.02793, -0.0315, 0.02849, 0.03649, -0.02383, 0.01999, 0.01361, -0.01562,
    0.02463, 0.01128, 0.03967, 0.007752, 0.01955, -0.1708, -0.02757, 0.03822, 0.0378, 0.02776, -0.05602, -0.06832,
    -0.04197, -0.008533, 0.004614, 0.1229, 0.01475, 0.08053, -0.2086, -0.002278, 0.04288, 0.08275, -0.2243, 0.04096,
    -0.2193, 0.05503, -0.05336, 0.06448, 0.02549, 0.02056, -0.09731, -0.006489, 0.116, -0.1199, -0.1538, -0.03503,
    -0.04764, 0.03448, 0.05017, 0.001361, -0.07552, -0.08071, 0.03126, 0.1019, -0.03143, -0.05852, 0.1777, 0.08892,
    -0.01733, -0.07185, -0.03373, -0.01349, -0.0005594, -0.01482, 0.1192, -0.005727, 0.1373, -0.01277, 0.1123, -0.09604,
    0.04212, 3.509e-05, -0.01332, 0.02605, -0.006435, 0.04758, -0.01955, 0.002435, -0.01119, -0.01951, 0.002261, -0.003719,
    0.1211, -0.006656, -0.01783, 0.04552, -0.007578, 0.1009, 0.103, 0.06336, 0.008259, 0.03175, -0.0843, 0.01631,
    0.0159, 0.1183, -0.004109, -0.026, -0.00915, -0.0009781, -0.01481, 0.06949, 0.0174, 0.002153, -0.005101, 0.01572,
    0.00659, -0.0126, -0.01401, -0.0248, 0.03731, 0.003882, -0.0401, -0.01706, -0.02336, 0.006424, -0.1087, -0.0382,
    0.01038, -0.000428, 0.005494, -0.01439, -0.08238, 0.02418, 0.02507, 0.02471, -0.01675, 0.04346, 0.03444, 0.0173,
    0.009552, 0.01114, 0.05273, -0.01579, -0.03394, -0.004599, 0.001982, 0.002325, -0.006627, -0.02372, -0.005496, -0.0003011,
    -0.01257, -0.008944, -0.01208, -0.007826, -0.01909, 0.007931, 0.004745, 0.003465, -0.0005447, 0.2127, -0.08475, 0.2885,
    0.1175, -0.3899, -0.1281, 0.3241, 0.264, -0.1066, -0.312, 0.1072, -0.2685, 0.1914, 0.3152, -0.1072,
    0.1606, 0.000137, 0.001018, -0.0001183, 0.006653, 0.006864, -0.0001286, 0.001077, 0.0001331, 0.001477, 0.0009035, -0.0008051,
    -0.00964, 0.01202, 0.001864, -0.002989, -0.003969, 0.03077, 0.01294, -0.0005231,
};
// clang-format on

/// Bias of the maximum of the parabolas over the true pressure [-]. `longer`: logarithm of the cell length along x over
/// the cell width.
double biasOf(const CellsAround& peak, const GapSteps& steps, double longer)
{
  static const TipNetwork tip(fitted_peak.data());
  static const SideNetwork side(fitted_peak.data() + TipNetwork::numbers);
  const float from_tips = tip(tipInputs(peak, -1, longer)) + tip(tipInputs(peak, 1, longer));
  const float from_sides = side(sideInputs(peak, steps, 1)) + side(sideInputs(peak, steps, -1));
  return peak.bendAlong() * static_cast<double>(from_tips) + static_cast<double>(from_sides);
}
}  // namespace

double peakPressure(const PatchGap& gap, double modulus, const CellsAround& peak)
{
  if (!peak.isInside())
  {
    return peak.top();
  }
  const GapSteps steps = gapSteps(peak, gap, modulus);
  if (areWaves(steps) || peak.isCutAlong())
  {
    return peak.parabolas();
  }
  const double most = most_of_bend * peak.bend();
  const double bias = biasOf(peak, steps, std::log(gap.grid.dx / gap.grid.dy));
  return peak.parabolas() / (1 + std::clamp(bias, -most, most));
}
}  // namespace wheel_rail_contact::core
