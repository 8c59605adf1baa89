// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include "ros/parameters/parameters.h"

namespace wheel_rail_contact
{
/// Reads the whole private namespace of a node or nodelet from the parameter server: see readNodeConfig().
/// @throw std::invalid_argument with the full name, the value and the violated rule
NodeConfig readNodeParameters(const ros::NodeHandle& private_nh);
}  // namespace wheel_rail_contact
