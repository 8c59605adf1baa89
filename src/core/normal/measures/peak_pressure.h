// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/measures/cells_around.h"

namespace wheel_rail_contact::core
{
/// Peak pressure, between the cells if necessary [Pa]. If a neighbouring cell across the track is not loaded, it is the
/// pressure of the peak cell. The pressure must solve `gap` on its grid, with E* = `modulus` [Pa].
///
/// The value is the maximum of the parabolas through the squared pressures of the peak cell and its neighbours, minus
/// its known bias (doc/theory.md, "Maximum pressure"). No bias is subtracted if the curvature of the gap jumps up and
/// down there (areWaves()), or if the border of the grid cuts the pressure along the track.
double peakPressure(const PatchGap& gap, double modulus, const CellsAround& peak);
}  // namespace wheel_rail_contact::core
