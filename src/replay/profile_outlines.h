// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact
{
// Outlines of wheels and rails as text, for drawing results: one line "y z" [m] per point, from the gauge side to the
// field side. y is outward on both sides.

/// Outline of an undeflected rail; of its first part, at x = 0 of the line, if it changes. Origin of the track frame.
std::string railOutlineText(const core::ContactModelConfig& config, core::Side side);
/// Outlines of a rail whose profile changes along the line, at the places of its sections and at equally many places
/// between any two of them: at most 200 places. Empty for a constant rail. A line "x PLACE" [m] comes before the points
/// of each outline; the parts of a rail at one place are separate outlines.
std::string railSectionsText(const core::ContactModelConfig& config, core::Side side);
/// Reference point of the undeflected rail head: the point to which RailDeflection refers. One line.
std::string railReferenceText(const core::ContactModelConfig& config, core::Side side);
/// Lower outline of a wheel without roll and yaw; origin at the axle centre.
std::string wheelOutlineText(const core::ContactModelConfig& config, core::Side side);
}  // namespace wheel_rail_contact
