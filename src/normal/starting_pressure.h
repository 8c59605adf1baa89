// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "patch_fields.h"

namespace wheel_rail_contact
{
/// Load of a pressure field [N], counted by the patches' weights.
double loadOf(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure);

/// Takes over the pressure of an earlier solution, scaled to the load where that is given.
/// Returns false (and leaves `pressure` undefined) if its shapes differ or it holds no pressure.
bool warmStart(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const NormalSolution& earlier,
               LaneBuffer& pressure);

/// A first pressure from the gap: proportional to the root of the interpenetration at half the approach, as in a
/// circular Hertz contact, where that is exact. Returns false if, at a given approach, nothing touches.
bool coldStart(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap,
               LaneBuffer& pressure);
}  // namespace wheel_rail_contact
