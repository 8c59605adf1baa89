// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/measures/cells_around.h"

namespace wheel_rail_contact::core
{
/// Highest pressure about a crest, between the cells if it lies there [Pa]; the cell's own where a cell beside it
/// across is not loaded. The pressure solves `gap` on its grid, with E* = `modulus` [Pa].
///
/// The top of the parabolas through the squared pressures of the crest and its neighbours, less what that is known to
/// be too large by (PeakBias): constant pressures on cells that meet the contact condition in their centres hold too
/// much at a crest, the more the sharper the pressure bends and by where between the cells it ends; beside a jump of
/// the gap's curvature D, as at the joint of two arcs, the pressure has a part -(E* D / 2 pi) t ln|t| (t the distance;
/// Hilbert's transform of the curvature, Johnson 1985, eq. 2.25b), which no parabola follows. All of that shows in the
/// pressures and in the gap about the crest, unless the gap's curvature goes to and fro there (areWaves()) or the
/// grid's border cuts the pressure along: then nothing is taken off.
double peakPressure(const PatchGap& gap, double modulus, const CellsAround& peak);
}  // namespace wheel_rail_contact::core
