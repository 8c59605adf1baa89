// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact
{
// Outlines of wheels and rails as text, for drawing results: one line "y z" [m] per point, from the gauge side to the
// field side. y is outward on both sides.

/// Outline of an undeflected rail; origin of the track frame.
std::string railOutlineText(const core::ContactModelConfig& config, core::Side side);
/// Reference point of the undeflected rail head: the point to which RailDeflection refers. One line.
std::string railReferenceText(const core::ContactModelConfig& config, core::Side side);
/// Lower outline of a wheel without roll and yaw; origin at the axle centre.
std::string wheelOutlineText(const core::ContactModelConfig& config, core::Side side);
}  // namespace wheel_rail_contact
