// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Series of cell aspects dx/dy whose influence coefficients are computed in advance: 2^(k/8) for the indices k = -24 …
/// 40, that is 1/8 to 32. A moving contact therefore computes no logarithm. Rounding to this series makes a box at most
/// 4.4 % larger than required.
namespace cell_aspect
{
constexpr int lowest_index = -24;  ///< index of aspect 1/8
constexpr int highest_index = 40;  ///< index of aspect 32

/// Aspect dx/dy of the series by its index [-].
double aspect(int index);

/// Smallest index of the series, continued beyond lowest_index and highest_index, whose value is at least `value` (>
/// 0).
int indexAbove(double value);

/// Index of the aspect nearest to `dx_over_dy` (> 0) in the logarithm, limited to lowest_index … highest_index.
int nearestIndex(double dx_over_dy);

/// Cell of an nx × ny grid whose aspect is in the series.
struct Cell
{
  double dx = 0, dy = 0;  ///< [m]
};

/// Smallest cell with an aspect of the series whose nx × ny grid covers `length` × `width` [m] (both > 0).
Cell coveringCell(double length, double width, int nx, int ny);
}  // namespace cell_aspect
}  // namespace wheel_rail_contact::core
