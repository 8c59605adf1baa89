// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact
{
// Outlines of the left wheel and the left rail as text, for drawing results: one line "y z" [m] per point, from the
// gauge side to the field side.

/// Outline of the undeflected rail, in track axes.
std::string railOutlineText(const core::ContactModelConfig& config);
/// Reference point of the undeflected rail head, in track axes: the point to which RailDeflection refers. One line.
std::string railReferenceText(const core::ContactModelConfig& config);
/// Lower outline of the wheel without roll and yaw. Axes parallel to the track axes, origin at the axle centre.
std::string wheelOutlineText(const core::ContactModelConfig& config);
}  // namespace wheel_rail_contact
