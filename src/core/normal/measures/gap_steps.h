// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/normal/measures/cells_around.h"

namespace wheel_rail_contact::core
{
constexpr int steps_reach = 6;  ///< number of columns considered on either side of a peak

/// Steps of the SecondDifference of the gap, over the peak pressure, from column to column in the row of a peak. The
/// first one is between the columns -steps_reach and 1 - steps_reach from the peak. Zero where a cell carries no
/// pressure or the body ends.
using GapSteps = std::array<double, static_cast<std::size_t>(2 * steps_reach)>;

GapSteps gapSteps(const CellsAround& peak, const PatchGap& gap, double modulus);

/// True if the curvature jumps up and down within a few cells, as on rough profiles. Curvature discontinuities cannot
/// be identified in that case.
bool areWaves(const GapSteps& steps);
}  // namespace wheel_rail_contact::core
