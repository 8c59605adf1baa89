// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/file_names.h"

#include <ros/package.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace wheel_rail_contact
{
namespace
{
const std::string package_scheme = "package://";

std::string packageFile(const std::string& name)
{
  const auto slash = name.find('/', package_scheme.size());
  const std::string package = name.substr(package_scheme.size(), slash - package_scheme.size());
  const std::string root = ros::package::getPath(package);
  if (root.empty())
  {
    throw std::invalid_argument(name + ": there is no ROS package '" + package + "'");
  }
  return slash == std::string::npos ? root : root + name.substr(slash);
}

std::vector<std::string> candidates(const std::string& name, const std::string& directory)
{
  if (name.rfind(package_scheme, 0) == 0)
  {
    return {packageFile(name)};
  }
  if (std::filesystem::path(name).is_absolute())
  {
    return {name};
  }
  std::vector<std::string> paths{(std::filesystem::path(directory) / name).string()};
  const std::string own = ros::package::getPath("wheel_rail_contact");
  if (!own.empty())
  {
    paths.push_back(own + "/" + name);
  }
  return paths;
}
}  // namespace

std::string resolveFile(const std::string& name, const std::string& directory)
{
  std::string searched;
  for (const auto& path : candidates(name, directory))
  {
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error))
    {
      return path;
    }
    searched += (searched.empty() ? "" : ", ") + path;
  }
  throw std::invalid_argument("no such file: " + name + " (searched: " + searched + ")");
}
}  // namespace wheel_rail_contact
