// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/solvers/hertz_solver.h"

namespace wheel_rail_contact::core
{
/// How the part of a gap below a level differs from that of a paraboloid, both on the gap's own cells.
struct OverlapMismatch
{
  double volume = 0;  ///< |logarithm of the ratio of volumes| [-]
  double shape = 0;   ///< volume that is not common to both, over the mean of both [-], 0 … 2
};

OverlapMismatch compareOverlap(const PatchGap& gap, const GapMinimum& paraboloid, double level);

/// The paraboloid, with axes along x and y, whose part below `level` has the volume's centre and second moments of the
/// gap's own. Needs a cell below the level.
GapMinimum momentParaboloid(const PatchGap& gap, double level);
}  // namespace wheel_rail_contact::core
