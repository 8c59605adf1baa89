// SPDX-License-Identifier: BSD-3-Clause
#include "edge_excess.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
/// Pressures two cells inward over those at the edge reach 1.4; beyond that they belong to another island.
constexpr double highest_input = 1.5;
/// Logarithms of the cells' shape that the weights were fitted for.
constexpr double longest_cells = 3.5;

/// The cell two inward from `p`, if no empty one lies between two loaded ones there.
double thirdInward(const double* p, std::ptrdiff_t outward)
{
  return p[0] > 0 && !(p[-outward] > 0) ? 0 : p[-2 * outward];
}
}  // namespace

EdgeInputs edgeInputs(const EdgeCrossing& crossing, double longer)
{
  const double *loaded = crossing.loaded, *left = loaded - crossing.sideways, *right = loaded + crossing.sideways;
  const std::ptrdiff_t outward = crossing.outward;
  const double scale = 1 / std::max({loaded[0], loaded[-outward], left[0], left[-outward], right[0], right[-outward]});
  const auto scaled = [scale](double p) { return std::min(scale * p, highest_input); };
  EdgeInputs inputs;
  inputs[0] = static_cast<float>(scaled(loaded[0]));
  inputs[1] = static_cast<float>(scaled(loaded[-outward]));
  inputs[2] = static_cast<float>(scaled(thirdInward(loaded, outward)));
  const std::array<double, 4> ones{left[outward], left[0], left[-outward], thirdInward(left, outward)};
  const std::array<double, 4> others{right[outward], right[0], right[-outward], thirdInward(right, outward)};
  for (std::size_t k = 0; k < ones.size(); ++k)
  {
    const auto place = static_cast<Eigen::Index>(k);
    const double one = scaled(ones[k]), other = scaled(others[k]);
    inputs[3 + place] = static_cast<float>(0.5 * (one + other));
    inputs[7 + place] = static_cast<float>(0.5 * std::abs(one - other));
  }
  const double shape = 0.5 * std::clamp(longer, -longest_cells, longest_cells);
  inputs[11] = static_cast<float>(crossing.along ? shape : -shape);
  return inputs;
}

float EdgeExcess::at(const EdgeInputs& inputs) const
{
  Eigen::Array<float, ramps, 1> ramp = offsets;
  for (int k = 0; k < edge_inputs; ++k)
  {
    ramp += slopes.col(k) * inputs[k];
  }
  return each + (linear * inputs).sum() + (heights * ramp.max(0.0F)).sum();
}

double EdgeExcess::of(double polygon) const
{
  return static_cast<double>(whole) + static_cast<double>(few_cells) / std::max(polygon, 1.0);
}
}  // namespace wheel_rail_contact
