// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/edge_bias.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core
{
namespace
{
/// Limit of the relative pressures. Two cells inward they reach 1.4; higher ones belong to another island.
constexpr float highest_input = 1.5F;
/// Limit of the logarithm of the cell aspect, up to which the weights were fitted.
constexpr double longest_cells = 3.5;

/// Pressures of a line: cell beyond the crossing, loaded cell at the crossing, and two cells inward.
struct Line
{
  float beyond, first, second, third;

  Line(const double* p, std::ptrdiff_t outward)
      : beyond(static_cast<float>(p[outward])),
        first(static_cast<float>(p[0])),
        second(static_cast<float>(p[-outward])),
        third(first > 0 && !(second > 0) ? 0.0F : static_cast<float>(p[-2 * outward]))
  {
  }
  float highest() const { return std::max(first, second); }
  void scale(float factor)
  {
    beyond = std::min(factor * beyond, highest_input);
    first *= factor;
    second *= factor;
    third = std::min(factor * third, highest_input);
  }
};

/// Output of test/calibration/fit_edge_bias.cpp in revision e6707df: crossing, island, few_cells. With the random
/// numbers of that revision the program finds other weights that leave the same errors. Nearly all contacts of the fit
/// for island and few_cells had a single island.
// clang-format off
constexpr std::array<double, EdgeBias::numbers> fitted_edge{
    -0.6668, 1.112, 0.6871, -0.3653, 0.02027, -0.4504, 0.9748, -0.1003, 0.01908, 0.3237, -0.33, 0.02157,
    -1.023, -0.2533, 0.9853, -0.5287, -0.9445, -0.3316, 0.596, -0.2171, -0.4308, -0.2954, -0.6617, 0.04237,
    0.5269, 0.2872, 0.002186, 0.4081, -0.7628, 0.2336, -0.006409, -0.599, -5.539, 0.3888, 0.1971, 0.428,
    0.06853, -0.08554, 0.1237, -24.84, 0.1848, 0.5933, 0.2759, 0.2808, 0.6778, 0.068, -3.531, -0.04693,
    -0.4872, -3.282, -0.1459, 0.2226, -0.9673, 0.538, 0.0844, 0.6995, -0.1176, 0.3796, 0.5903, -2.161,
    0.1027, 0.3594, 0.8929, -0.4907, 0.2643, -2.06, -1.762, 0.4454, -0.6098, -0.1363, -0.4324, -0.4784,
    0.08381, -0.9215, 0.1999, 0.02668, 0.08473, 0.2323, 0.1752, 0.022, -0.2494, -0.03307, -0.3385, -0.7391,
    -0.127, 0.3702, -0.6027, 0.3417, -0.00494, -0.5908, -0.38, 0.4947, 1.111, -0.06492, -0.7063, 0.334,
    0.5824, -0.09551, -0.2124, -0.09812, -0.1316, 0.4957, 0.1426, -0.8103, -1.031, 0.019, -0.411, -0.2423,
    -0.3039, -0.68, -0.1792, -0.3471, -0.3863, -3.355, -0.07364, 0.2078, -1.618, 0.7755, 0.3446, -1.099,
    -0.919, 0.09062, 0.6581, -3.306, -0.415, -0.5693, -0.3496, 0.7149, 0.4542, -1.828, -0.3334, -0.7544,
    -0.1647, -0.2445, -0.5572, -1.682, -1.122, 0.6428, -0.3357, -1.096, -0.1738, -0.02412, 0.5368, 0.932,
    -0.5852, -0.03454, 0.6242, -0.8136, 0.8012, -0.81, 0.1247, 0.4404, -1.919, -2.067, -0.04373, -0.8529,
    -0.5047, -0.7468, -0.9742, -0.05179, 0.1462, -0.07651, -0.2431, 0.9252, -0.007546, -0.5918, 0.2887, 0.2102,
    0.5761, -0.04221, 0.2302, -0.02369, 0.1692, 0.05973, -0.5309, 0.8082, 0.03466, -0.0107, 0.006472, -0.08998,
    -1.086, 0.4435, -0.06363, -0.06322, 0.1525, 0.1906, -0.5675, -0.5025, -0.238, 0.03755, -0.001616, -0.0525,
    0.2245, 0.008837, -0.1991, 0.1164, -0.1779, -0.9405, 0.241, 0.7385, 0.3987, -0.693, 0.01515, -0.4524,
    -0.1783, -0.3427, -0.002437, -0.01126, 0.3264, -0.7536, 0.618, 0.2848, -0.05124, 0.1204, 0.3275, 0.7463,
    -0.06863, -0.8645, 0.06779, 0.03956, 0.04676, 0.02178, -0.4289, 0.08724, -0.02857, -0.08851, 0.02846, -0.008543,
    0.08624, -0.01157, 0.02583, -0.009378, 0.09853, -0.02304, -0.05388, 0.02266, -0.02324, -0.3512, -1.071,
};
// clang-format on
}  // namespace

EdgeInputs edgeInputs(const EdgeCrossing& crossing, double longer)
{
  Line own(crossing.loaded, crossing.outward), left(crossing.loaded - crossing.sideways, crossing.outward),
      right(crossing.loaded + crossing.sideways, crossing.outward);
  const float highest = std::max(own.highest(), std::max(left.highest(), right.highest()));
  const float scale = 1 / std::max(highest, std::numeric_limits<float>::min());
  own.scale(scale);
  left.scale(scale);
  right.scale(scale);
  const auto shape = static_cast<float>(0.5 * std::clamp(longer, -longest_cells, longest_cells));
  EdgeInputs inputs;
  inputs << own.first, own.second, own.third,  //
      0.5F * (left.beyond + right.beyond), 0.5F * (left.first + right.first), 0.5F * (left.second + right.second),
      0.5F * (left.third + right.third),  //
      0.5F * std::abs(left.beyond - right.beyond), 0.5F * std::abs(left.first - right.first),
      0.5F * std::abs(left.second - right.second), 0.5F * std::abs(left.third - right.third),  //
      crossing.along ? shape : -shape, 1;
  return inputs;
}

double EdgeBias::of(double polygon, int islands) const
{
  const double each = polygon / std::max(islands, 1);
  return islands * (static_cast<double>(island) + static_cast<double>(few_cells) / std::max(each, 1.0));
}

const EdgeBias& edgeBias()
{
  static const EdgeBias bias{EdgeBias::Crossing(fitted_edge.data()),
                             static_cast<float>(fitted_edge[fitted_edge.size() - 2]),
                             static_cast<float>(fitted_edge.back())};
  return bias;
}
}  // namespace wheel_rail_contact::core
