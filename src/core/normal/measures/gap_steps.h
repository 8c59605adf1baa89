// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/normal/measures/cells_around.h"

namespace wheel_rail_contact::core
{
constexpr int steps_reach = 6;  ///< columns looked at to either side of a crest

/// Steps of the gap's SecondDifference over the crest's pressure, between the columns about a crest in its row (the
/// first between those -steps_reach and 1 - steps_reach columns from it). Zero where a cell carries nothing or the body
/// ends.
using GapSteps = std::array<double, static_cast<std::size_t>(2 * steps_reach)>;

GapSteps gapSteps(const CellsAround& peak, const PatchGap& gap, double modulus);

/// The curvature jumps to and fro within a few cells, as on rough profiles: then nothing is known of its jumps.
bool areWaves(const GapSteps& steps);
}  // namespace wheel_rail_contact::core
