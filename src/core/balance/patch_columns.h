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

/// Sets weights and normals of the columns. The reference is the column with the deepest overlap.
/// @param spare  memory of `turn` while the normals hardly turn
void setNormals(const std::vector<SurfaceColumn>& columns, PatchGap& patch, Eigen::ArrayXd& spare);

/// Sets PatchGap::unseen_slope.
void setUnseenSlope(const std::vector<SurfaceColumn>& columns, PatchGap& patch);
}  // namespace wheel_rail_contact::core
