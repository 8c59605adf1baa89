// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

namespace wheel_rail_contact
{
/// Cosine modes of a direction with n = 2 half cells on a grid of twice that length.
///
/// The even part of a field has values at x = k + 1/2, k < half, and the modes cos(pi a x / n), a < n. Its odd part,
/// multiplied by (-1)^k, has the same sums as its sine modes n - a. Modes are ordered even a first, so that the first
/// half of them are the modes of the grid's own period n.
struct CosineModes
{
  explicit CosineModes(int half_cells);

  /// Mode number of a place in that order, for the even part [0] and the odd part [1].
  int number(int parity, int place) const;

  int half = 0;   ///< values of one part
  int count = 0;  ///< modes, 2 half
  int value_stride = 0;
  int mode_stride = 0;
  LaneBuffer by_mode;   ///< [value][mode]: modes contiguous
  LaneBuffer by_value;  ///< [mode][value]: values contiguous
  LaneBuffer sign;      ///< (-1)^k
};
}  // namespace wheel_rail_contact
