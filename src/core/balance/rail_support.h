// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/track/gap.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/rail_compliance.h"

namespace wheel_rail_contact::core
{
/// A rail head as the support of its patches. Coordinates, side axes: lateral outward [m], vertical up [m], outward
/// roll about the head's reference point [rad]; the forces along them: outward on the rail [N], up on the rail [N],
/// moment on the head about that point [N m].
Eigen::Vector3d toCoordinates(const RailDeflection& deflection);
/// The deflection that has these coordinates.
RailDeflection toDeflection(const Eigen::Vector3d& coordinates);

/// Compliance of the coordinates, from a table for the upright rail, inclined by `inclination` [rad].
Eigen::Matrix3d supportCompliance(const ComplianceTable& table, double inclination);

/// Way of a rail's point when its head moves by `move` (small), side axes (y, z) [m].
Eigen::Vector2d displacementOf(const PlacedRail& rail, double y, double z, const Eigen::Vector3d& move);

/// How far a unit of each coordinate opens the gap over a plane, at each of its columns. The rail's surface at a place
/// of the plane changes by the normal part of its way, less its slope times the tangential part. For the vertical
/// coordinate the slope is left out, so that the vertical force is the load as NormalProblem counts it.
void fillOpening(const PlacedRail& rail, const ContactPlane& plane, const Grid& grid,
                 const std::vector<GapColumn>& columns, Eigen::ArrayX3d& opening);
}  // namespace wheel_rail_contact::core
