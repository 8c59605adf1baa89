// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

namespace wheel_rail_contact
{
/// Colour scale of the pressure between the rails, with labels in MPa: markers "scale". If a pressure is above the
/// scale, a field in aboveScaleColor() and the pressure are above its upper end.
/// @param x of the scale, track frame [m]
/// @param max_pressure upper end of the scale [Pa], > 0
/// @param highest highest drawn pressure [Pa]
void addScale(double x, double max_pressure, double highest, const std_msgs::Header& header,
              visualization_msgs::MarkerArray& markers);
}  // namespace wheel_rail_contact
