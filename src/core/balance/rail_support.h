// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/track/gap.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/rail_compliance.h"

namespace wheel_rail_contact::core
{
/// Rail head as the support of its patches: coordinates of a deflection, side axes. They are lateral outward [m],
/// vertical up [m] and outward roll about the reference point of the head [rad]. The forces along them are the outward
/// force on the rail [N], the upward force on the rail [N] and the moment on the head about that point [N m].
Eigen::Vector3d toCoordinates(const RailDeflection& deflection);
/// Deflection with these coordinates.
RailDeflection toDeflection(const Eigen::Vector3d& coordinates);

/// Compliance along the coordinates, from the table of the upright rail, for a rail inclined by `inclination` [rad].
Eigen::Matrix3d supportCompliance(const ComplianceTable& table, double inclination);

/// Displacement (y and z components) of the point (y, z) of the rail for a small displacement `move` of its head, side
/// axes [m].
Eigen::Vector2d displacementOf(const PlacedRail& rail, double y, double z, const Eigen::Vector3d& move);

/// Opening of the gap at each column of a plane per unit of each coordinate. The rail surface at a position of the
/// plane moves by the normal part of the displacement minus its slope times the tangential part. For the vertical
/// coordinate the slope is left out. The vertical force then equals the load as defined by NormalProblem.
void fillOpening(const PlacedRail& rail, const ContactPlane& plane, const Grid& grid,
                 const std::vector<GapColumn>& columns, Eigen::ArrayX3d& opening);
}  // namespace wheel_rail_contact::core
