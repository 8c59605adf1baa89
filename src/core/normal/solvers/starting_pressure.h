// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/solvers/patch_fields.h"

namespace wheel_rail_contact::core
{
/// Load of a pressure field [N]: weighted sum over the patches.
double loadOf(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure);

/// Scales a pressure field, and its displacement unless it is null, to the load of the problem.
void scaleToLoad(const NormalProblem& problem, const std::vector<PatchLayout>& patches, LaneBuffer& pressure,
                 LaneBuffer* displacement);

/// Common approach of first touch [m].
double firstTouch(const std::vector<PatchLayout>& patches);

/// Rough approach that carries the load [m], from circular Hertz contacts with the interpenetration areas of the
/// patches at half of it. `gap` contains the cells of the patches in any order.
double approachForLoad(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap);

/// Result of a start.
enum class Start
{
  none,      ///< no starting point
  pressure,  ///< pressure only
  complete   ///< pressure and its displacement
};

/// Takes the pressure of an earlier solution, in load control scaled to the load. Also takes its displacement if this
/// still belongs to the pressure (same aspect of the cells).
Start warmStart(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const NormalSolution& earlier,
                LaneBuffer& pressure, LaneBuffer& displacement);

/// First pressure from the gap, proportional to the root of the interpenetration at half the approach; this is exact
/// for a circular Hertz contact. Returns Start::none if nothing touches at a given approach.
Start coldStart(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap,
                LaneBuffer& pressure);
}  // namespace wheel_rail_contact::core
