// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/solvers/hertz_solver.h"

namespace wheel_rail_contact::core
{
/// Difference between the part of a gap below a level and that of a paraboloid, both on the cells of the gap.
struct OverlapMismatch
{
  double volume = 0;  ///< |ln(ratio of the volumes)| [-]
  double shape = 0;   ///< volume that is not common to both, over the mean of both [-], 0 … 2
};

OverlapMismatch compareOverlap(const PatchGap& gap, const GapMinimum& paraboloid, double level);

/// Paraboloid, with axes along x and y, whose part below `level` has the centroid and second moments of the volume of
/// the gap below it. Requires at least one cell below the level.
GapMinimum momentParaboloid(const PatchGap& gap, double level);
}  // namespace wheel_rail_contact::core
