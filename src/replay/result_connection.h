// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bag/bag_contents.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact
{
/// Connection of the results of a wheelset. Its header contains the description of the replay and, for drawing results,
/// outlines as text: one line "y z" [m] per point, from the gauge side to the field side. y is outward on both sides.
///
/// - SIDE_rail_outline: an undeflected rail; its first part, at x = 0 of the line, if it changes. Origin of the track
///   frame.
/// - SIDE_rail_sections: only of a rail whose profile changes along the line, at the places of its sections and at
///   equally many places between any two of them: at most 200 places. A line "x PLACE" [m] comes before the points of
///   each outline; the parts of a rail at one place are separate outlines.
/// - SIDE_rail_reference: the point of the undeflected rail head to which RailDeflection refers.
/// - SIDE_wheel_outline: lower outline of a wheel without roll and yaw; origin at the axle centre.
BagConnection resultConnection(const std::string& wheelset, const std::string& description,
                               const core::ContactModelConfig& model);
}  // namespace wheel_rail_contact
