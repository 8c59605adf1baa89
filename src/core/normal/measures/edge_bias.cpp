// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/edge_bias.h"

#include <algorithm>
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
}  // namespace wheel_rail_contact::core
