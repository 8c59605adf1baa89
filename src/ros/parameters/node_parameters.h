// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include "config/node_config.h"

namespace wheel_rail_contact
{
/// A namespace of the parameter server as a YAML document. Numbers are written with 17 digits and keep their exact
/// value: a parameter from the server is identical to one from the file.
/// The value is a copy, because before ROS 1.15 an XmlRpcValue gives no access to its content if it is const.
/// @throw std::invalid_argument for dates and binary data.
YAML::Node toYaml(XmlRpc::XmlRpcValue value);

/// Reads the whole private namespace of a node or nodelet from the parameter server: see readNodeConfig().
/// @throw std::invalid_argument with the full name, the value and the violated rule
NodeConfig readNodeParameters(const ros::NodeHandle& private_nh);
}  // namespace wheel_rail_contact
