// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/balance/grid_levels.h"
#include "core/track/gap.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Part of the surface of a rail that a grid must cover: x along the track and the arc of the section from a point of
/// the profile.
struct SurfaceArea
{
  double x_least = 0, x_most = 0;      ///< [m]
  double arc_least = 0, arc_most = 0;  ///< [m]
  SurfaceOrigin origin;                ///< the point from which the arc is counted; its x is not used
  double half_length = 0;              ///< of the expected pressure along the track [m]
  bool whole = true;                   ///< the whole overlap, which the pressure cannot leave
};

/// A grid and its origin on the surface.
struct GridLayout
{
  Grid grid;
  SurfaceOrigin origin;

  /// True if both have the same cells.
  bool equals(const GridLayout& other) const;
};

/// Grid that covers an area. Its cells are equal for similar areas: their lengths and widths are from a series with
/// eight steps an octave, and they lie at multiples of these from fixed places of the track and of the profile. Results
/// of states that differ little are therefore from the same cells.
/// @param symmetric  the area is symmetric about x = 0, and the grid too
GridLayout layGrid(const SurfaceArea& area, const GridSize& size, bool symmetric);

/// True if a grid covers an area and is not much larger.
/// @param shift        arc length from the origin of the grid to that of the area [m]
/// @param most_larger  largest length of the grid over that of the area, and of its width [-]
bool covers(const GridLayout& layout, const SurfaceArea& area, double shift, double most_larger);
}  // namespace wheel_rail_contact::core
