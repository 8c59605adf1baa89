// SPDX-License-Identifier: BSD-3-Clause
#pragma once


#include "core/track/placement.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Displacement of the rail of each Side at a place of a line, from its place in the ideal track. Side axes.
/// @param at_rest  reference points of the rails in the ideal track, side axes
Sides<RailDeflection> displacementsAt(const LineStation& station, const Sides<PlanePoint>& at_rest);

/// Angle by which displaced rails turn the track, left up positive [rad].
/// @param half_base  half the distance of the running circles [m]
double tiltOf(const Sides<RailDeflection>& displaced, double half_base);
}  // namespace wheel_rail_contact::core
