// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/package.h>

#include <string>

#include "ros/parameters/parameters.h"

namespace wheel_rail_contact::core::paper
{
inline std::string shipped(const std::string& name)
{
  return ros::package::getPath("wheel_rail_contact") + "/config/" + name;
}

/// config/paper.yaml merged into config/default.yaml, as by contact.launch.
inline NodeConfig paperConfig()
{
  return readNodeConfig(overlay(readParameterFile(shipped("default.yaml")), readParameterFile(shipped("paper.yaml"))),
                        "/contact_node/", "/");
}
}  // namespace wheel_rail_contact::core::paper
