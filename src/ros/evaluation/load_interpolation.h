// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/WrenchStamped.h>

#include <string>

namespace wheel_rail_contact
{
/// Load at a stamp, linear in time between two loads. Force and moment in the axes of the loads [N], [N m].
/// @param before,after loads whose stamps enclose `stamp`, or the same load with this stamp
/// @return the load with the stamp, and with the frame_id of `after`
geometry_msgs::WrenchStamped interpolatedLoad(const geometry_msgs::WrenchStamped& before,
                                              const geometry_msgs::WrenchStamped& after, const ros::Time& stamp);

/// Reason why two loads cannot be interpolated: their frame_id differ. Empty if they are equal.
std::string interpolationFault(const geometry_msgs::WrenchStamped& before, const geometry_msgs::WrenchStamped& after);
}  // namespace wheel_rail_contact
