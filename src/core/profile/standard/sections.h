// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core::standard
{
constexpr double mm = 1e-3;  ///< [m]; the standards give their values in millimetres

/// Half of the circle that contains an arc. Arcs run in the direction of growing y: clockwise on the upper half.
enum class Half
{
  upper,
  lower
};

/// Arc from y = y_start to y = y_end (all values in mm).
inline ProfileSection arc(Half half, double yc, double zc, double radius, double y_start, double y_end)
{
  const double turn = half == Half::upper ? -1.0 : 1.0;
  const auto angle_at = [&](double y) { return -turn * std::acos(std::clamp((y - yc) / radius, -1.0, 1.0)); };
  const double start = angle_at(y_start);
  const double sweep = turn * (angle_at(y_end) - start);
  return {ArcSection{yc * mm, zc * mm, radius * mm, start, turn}, radius * mm * sweep};
}

/// Straight section between two points [mm].
inline ProfileSection line(double y0, double z0, double y1, double z1)
{
  const double length = std::hypot(y1 - y0, z1 - z0);
  return {LineSection{y0 * mm, z0 * mm, (y1 - y0) / length, (z1 - z0) / length}, length * mm};
}

/// Section z = -sum down[k] y^k, with the coefficients of the standard [mm^(1-k)], in which z points down.
template <std::size_t Count>
ProfileSection polynomial(const std::array<double, Count>& down, double y_start, double y_end)
{
  static_assert(Count <= PolynomialSection::max_coefficients, "too many coefficients");
  PolynomialSection law{y_start * mm, {}, Count};
  double scale = -mm;
  for (std::size_t k = 0; k < Count; ++k)
  {
    law.coefficient[k] = down[k] * scale;
    scale /= mm;
  }
  return {law, (y_end - y_start) * mm};
}
}  // namespace wheel_rail_contact::core::standard
