// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/core/rail_compliance.h"

namespace wheel_rail_contact::core
{
/// What a force on a rail does to the same rail's head some way along it. The entries are those of a compliance table,
/// of any sign: a rail on pads rises beside its load.
struct RailInfluence
{
  double distance = 0;        ///< along the rail, in either direction [m], > 0
  ComplianceTable influence;  ///< what unit forces do there
};

/// Influence at a distance [m]; between two listed ones linear in the distance.
/// @param listed distances rising
/// @throw std::invalid_argument if the distance lies outside those listed.
ComplianceTable influenceAt(const std::vector<RailInfluence>& listed, double distance);

/// Force of another wheelset's wheel on the same rail, and what it does here.
struct NeighbourForce
{
  ComplianceTable influence;  ///< at the distance of that wheel
  RailForce force;            ///< axes of the rail's side, at the other wheel
};

/// Deflection by all of them: their sum, small displacements. Track axes of the rail's side, the rail inclined by
/// `inclination` [rad] towards the track's centre.
RailDeflection neighbourDeflection(const std::vector<NeighbourForce>& neighbours, double inclination);
}  // namespace wheel_rail_contact::core
