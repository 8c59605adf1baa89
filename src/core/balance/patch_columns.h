// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/track/gap.h"
#include "wheel_rail_contact/core/normal_problem.h"

// What a patch takes from the columns of its gap.
namespace wheel_rail_contact::core
{
/// Leaves columns out that a vertical displacement hardly opens, or closes.
void leaveOutWalls(const std::vector<SurfaceColumn>& columns, PatchGap& patch);

/// Sets weight and normals. The reference is the column with the deepest overlap. The turn is zero where the normals
/// hardly turn.
void setNormals(const std::vector<SurfaceColumn>& columns, PatchGap& patch, ColumnNormals& normals);

/// Sets PatchGap::unseen_slope.
void setUnseenSlope(const std::vector<SurfaceColumn>& columns, PatchGap& patch);
}  // namespace wheel_rail_contact::core
