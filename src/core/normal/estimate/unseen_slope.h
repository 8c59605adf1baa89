// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Fills PatchGap::unseen_slope from the slopes of the gap. Error estimates use it to detect features that are narrower
/// than the cells.
///
/// With the third differences t of the gap on both sides of column j, a kink or a jump of the curvature makes the
/// slopes differ by no more than (|t_before| + |t_after|) / (4 dy). Only the part of the difference above this limit is
/// stored.
/// @param patch     grid and gap must be filled
/// @param slope_at  returns the slope d(gap)/dy at x = 0 of a column j [-]
template <typename SlopeAt>
void fillUnseenSlope(PatchGap& patch, SlopeAt slope_at)
{
  const Grid& grid = patch.grid;
  const int behind = grid.symmetric ? 0 : (grid.nx - 1) / 2, ahead = grid.symmetric ? 0 : grid.nx / 2;
  const auto line = [&](Eigen::Index j) { return 0.5 * (patch.gap(behind, j) + patch.gap(ahead, j)); };
  const auto third = [&](Eigen::Index j) { return line(j + 2) - 3 * line(j + 1) + 3 * line(j) - line(j - 1); };
  patch.unseen_slope.setZero(grid.ny);
  for (Eigen::Index j = 2; j < grid.ny - 2; ++j)
  {
    const double shown = 0.5 * (line(j + 1) - line(j - 1));
    const double off = std::abs(slope_at(j) * grid.dy - shown);
    const double bends = 0.25 * (std::abs(third(j - 1)) + std::abs(third(j)));
    patch.unseen_slope[j] = std::max(off - bends, 0.0) / grid.dy;
  }
}
}  // namespace wheel_rail_contact::core
