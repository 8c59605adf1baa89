// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "ros/node/contact_evaluator.h"
#include "ros/parameters/parameters.h"

namespace wheel_rail_contact
{
/// Picture of an answer in the track frame: the deflected rails, the wheelset, and for each patch
/// - its pressure as coloured surface in true size ("patch") and magnified above its rail ("zoom"; patches of one wheel
///   side by side in their order across the track), with a line that leads from one to the other ("zoom_line"),
/// - the wheel's force on the rail as an arrow from the patch into the rail ("force"),
/// - a label with highest pressure and area ("label").
/// Numbers: side * 16 + place of the patch in the answer's side. An answer that is not usable shows its reason
/// ("status").
visualization_msgs::MarkerArray contactMarkers(const ContactAnswer& answer, const NodeConfig& config);
}  // namespace wheel_rail_contact
