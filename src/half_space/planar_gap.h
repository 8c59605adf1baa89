// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/track/gap.h"
#include "core/track/placement.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core::half_space
{
/// Gap of the planar model, in place of the gap along the normals of the rail: wheel and rail are heights over the
/// plane that touches the rail in one column, and cells lie on this plane (Johnson 1985, section 4.1).
/// @param columns  columns of the grid on the surface of the rail
/// @param grid     its cells; those on the plane have the same sizes, and the same distances from the touching column
/// @param touch    column at which the plane touches the rail
/// @return weight and gap; without gap if wheel or rail has no point over a cell
PatchGap planarGap(const PlacedWheel& wheel, const PlacedRail& rail, const std::vector<SurfaceColumn>& columns,
                   const Grid& grid, Eigen::Index touch);
}  // namespace wheel_rail_contact::core::half_space
