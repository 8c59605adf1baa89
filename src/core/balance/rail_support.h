// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/track/rail_along.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core
{
/// Rail of a side in the ideal track, along the line. Keeps a reference to its sections, if it has any.
RailAlong railAlong(const ContactModelConfig& config, Side side);
/// Rail of a side in the ideal track at the place x of the line [m]. For pictures: RailAlong is faster where the
/// profile changes. Side axes.
PlacedRail restingRail(const ContactModelConfig& config, Side side, double x = 0);

/// Coordinates of the deflection of a rail head, side axes. They are lateral outward [m],
/// vertical up [m] and outward roll about the reference point of the head [rad]. The forces along them are the outward
/// force on the rail [N], the upward force on the rail [N] and the moment on the head about that point [N m].
Eigen::Vector3d toCoordinates(const RailDeflection& deflection);
/// Deflection with these coordinates.
RailDeflection toDeflection(const Eigen::Vector3d& coordinates);

/// Compliance along the coordinates, from the table of the upright rail, for a rail inclined by `inclination` [rad].
Eigen::Matrix3d supportCompliance(const ComplianceTable& table, double inclination);
}  // namespace wheel_rail_contact::core
