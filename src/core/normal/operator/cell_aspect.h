// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Cell aspects dx/dy whose influence coefficients are computed ahead: 2^(k/8) for k = -24 … 40 (1/8 to 32), so that a
/// moving contact meets no logarithm. A step of 2^(1/8) makes a box at most 4.4 % larger than wanted.
namespace aspect_ladder
{
constexpr int kLowest = -24;  ///< rung of aspect 1/8
constexpr int kHighest = 40;  ///< rung of aspect 32

/// Aspect dx/dy of a rung [-].
double aspect(int level);

/// GridLevel nearest to `dx_over_dy` (> 0) in the logarithm, within the ladder.
int nearestAspect(double dx_over_dy);

/// Cell of a grid nx × ny with its aspect on the ladder.
struct Cell
{
  double dx = 0, dy = 0;  ///< [m]
};

/// Smallest cell on the ladder whose grid of nx × ny covers `length` × `width` [m] (both > 0).
Cell coveringCell(double length, double width, int nx, int ny);
}  // namespace aspect_ladder
}  // namespace wheel_rail_contact::core
