// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <array>

#include "wheel_rail_contact/geometry/placement.h"
#include "wheel_rail_contact/ros/parameters.h"

namespace wheel_rail_contact
{
/// Both rails, deflected as given by Side, as short surfaces about `header`'s x = `x` [m]: markers "rail".
void addRails(const NodeConfig& config, const std_msgs::Header& header, double x,
              const std::array<RailDeflection, 2>& deflection, visualization_msgs::MarkerArray& markers);

/// The wheelset: the part of each tread that is near the rail as surface, with the profile along its rear end; circles
/// of each wheel and the axle as lines: markers "wheel", "wheel_profile", "wheel_lines".
void addWheelset(const NodeConfig& config, const std_msgs::Header& header, double x, const WheelsetPose& pose,
                 visualization_msgs::MarkerArray& markers);

/// What does not change: both rails at rest as lines ("rail_at_rest") and the scale of pressure colours ("scale").
visualization_msgs::MarkerArray profileMarkers(const NodeConfig& config);
}  // namespace wheel_rail_contact
