// SPDX-License-Identifier: BSD-3-Clause
#include "edge_excess.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
/// Pressures two cells inward over those at the edge reach 1.4; beyond that they belong to another island.
constexpr double highest_input = 1.5;
}  // namespace

EdgeInputs edgeInputs(const EdgeCrossing& crossing, double longer)
{
  const double *loaded = crossing.loaded, *left = loaded - crossing.sideways, *right = loaded + crossing.sideways;
  const std::ptrdiff_t outward = crossing.outward;
  const double scale = 1 / std::max({loaded[0], loaded[-outward], left[0], left[-outward], right[0], right[-outward]});
  const auto scaled = [scale](const double* p) { return std::min(scale * *p, highest_input); };
  EdgeInputs inputs;
  for (int k = 0; k < 3; ++k)
  {
    inputs[k] = static_cast<float>(scaled(loaded - k * outward));
  }
  for (int k = 0; k < 4; ++k)
  {
    const double one = scaled(left + (1 - k) * outward), other = scaled(right + (1 - k) * outward);
    inputs[3 + k] = static_cast<float>(0.5 * (one + other));
    inputs[7 + k] = static_cast<float>(0.5 * std::abs(one - other));
  }
  inputs[11] = static_cast<float>(crossing.along ? 0.5 * longer : -0.5 * longer);
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
