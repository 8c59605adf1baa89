// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact
{
// Outlines of the left wheel and rail as text, a line "y z" [m] for each point, from the gauge side to the field side:
// what a picture of the answers needs to know about the profiles.

/// The rail at rest, track axes.
std::string railOutlineText(const core::ContactModelConfig& config);
/// The point of the rail's head at rest whose way RailDeflection tells; one line, track axes.
std::string railReferenceText(const core::ContactModelConfig& config);
/// The wheel's lowest points, axes of the wheelset without roll and yaw, origin in the axle's centre.
std::string wheelOutlineText(const core::ContactModelConfig& config);
}  // namespace wheel_rail_contact
