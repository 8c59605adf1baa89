// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/core/rail_compliance.h"

namespace wheel_rail_contact::core
{
/// Deflection of a rail head by unit forces on the same rail at a distance along it. The table has the entries of a
/// compliance table, here of any sign: next to a load, a rail on pads rises.
struct RailInfluence
{
  double distance = 0;        ///< distance along the rail, in either direction [m], > 0
  ComplianceTable influence;  ///< deflection by unit forces at this distance
};

/// Influence at a distance [m], interpolated linearly between the listed distances.
/// @param listed in the order of increasing distance
/// @throw std::invalid_argument if the distance is outside the range of the listed ones.
ComplianceTable influenceAt(const std::vector<RailInfluence>& listed, double distance);

/// Force of a wheel of another wheelset on the same rail, with its influence on this wheelset.
struct NeighbourForce
{
  ComplianceTable influence;  ///< influence at the distance of the other wheel
  RailForce force;            ///< force at the other wheel, in the axes of the side of the rail
};

/// Deflection of a rail head by the forces of all neighbouring wheels: the sum of small displacements, in track axes
/// (outward, up). The rail is inclined by `inclination` [rad] towards the track centre.
RailDeflection neighbourDeflection(const std::vector<NeighbourForce>& neighbours, double inclination);
}  // namespace wheel_rail_contact::core
