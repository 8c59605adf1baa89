// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/node_parameters.h"

#include <ros/param.h>

#include <filesystem>

namespace wheel_rail_contact
{
NodeConfig readNodeParameters(const ros::NodeHandle& private_nh)
{
  const std::string& name = private_nh.getNamespace();
  XmlRpc::XmlRpcValue value;
  ros::param::get(name, value);  // without any parameter of the node the value, and the tree, stay empty
  return readNodeConfig(parameterTree(toYaml(value)), name + "/", std::filesystem::current_path().string());
}
}  // namespace wheel_rail_contact
