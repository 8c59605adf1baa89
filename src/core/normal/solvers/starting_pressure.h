// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/solvers/patch_fields.h"

namespace wheel_rail_contact::core
{
/// Load of a pressure field [N], counted by the patches' weights.
double loadOf(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure);

/// Common approach at which anything touches [m].
double firstTouch(const std::vector<PatchLayout>& patches);

/// Rough approach that carries the load [m]: that of circular Hertz contacts with the patches' areas of
/// interpenetration at half of it. `gap` holds the patches' cells in any order.
double approachForLoad(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap);

/// What a start found.
enum class Start
{
  none,      ///< nothing to start from
  pressure,  ///< pressure only
  complete   ///< pressure and its displacement
};

/// Takes over the pressure of an earlier solution, scaled to the load where that is given, and its displacement if that
/// still belongs to it (same aspect of the cells).
Start warmStart(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const NormalSolution& earlier,
                LaneBuffer& pressure, LaneBuffer& displacement);

/// A first pressure from the gap: proportional to the root of the interpenetration at half the approach, as in a
/// circular Hertz contact, where that is exact. None if, at a given approach, nothing touches.
Start coldStart(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap,
                LaneBuffer& pressure);
}  // namespace wheel_rail_contact::core
