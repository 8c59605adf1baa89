// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "wheel_rail_contact/core/rail_compliance.h"

namespace wheel_rail_contact::core
{
/// Coordinates of the deflection of a rail head, side axes. They are lateral outward [m],
/// vertical up [m] and outward roll about the reference point of the head [rad]. The forces along them are the outward
/// force on the rail [N], the upward force on the rail [N] and the moment on the head about that point [N m].
Eigen::Vector3d toCoordinates(const RailDeflection& deflection);
/// Deflection with these coordinates.
RailDeflection toDeflection(const Eigen::Vector3d& coordinates);

/// Compliance along the coordinates, from the table of the upright rail, for a rail inclined by `inclination` [rad].
Eigen::Matrix3d supportCompliance(const ComplianceTable& table, double inclination);
}  // namespace wheel_rail_contact::core
