// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/config_file.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "config/node_config.h"
#include "core/option_check.h"
#include "core/text/words.h"

namespace wheel_rail_contact
{
namespace
{
const std::string package_scheme = "package://";

std::string folderOf(const std::string& package, const FileSearch& search)
{
  return search.package_folder ? search.package_folder(package) : "";
}

std::string packageFile(const std::string& name, const FileSearch& search)
{
  const auto slash = name.find('/', package_scheme.size());
  const std::string package = name.substr(package_scheme.size(), slash - package_scheme.size());
  const std::string root = folderOf(package, search);
  core::refuseIf(root.empty(), name + ": there is no ROS package '" + package + "'");
  return slash == std::string::npos ? root : root + name.substr(slash);
}

std::vector<std::string> candidates(const std::string& name, const FileSearch& search)
{
  if (name.rfind(package_scheme, 0) == 0)
  {
    return {packageFile(name, search)};
  }
  if (std::filesystem::path(name).is_absolute())
  {
    return {name};
  }
  std::vector<std::string> paths{(std::filesystem::path(search.directory) / name).string()};
  const std::string own = folderOf("wheel_rail_contact", search);
  if (!own.empty())
  {
    paths.push_back(own + "/" + name);
  }
  return paths;
}
}  // namespace

std::string FileSearch::find(const std::string& name) const
{
  const std::vector<std::string> paths = candidates(name, *this);
  for (const auto& path : paths)
  {
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error))
    {
      return path;
    }
  }
  throw std::invalid_argument("no such file: " + name + " (searched: " + core::joined(paths, ", ") + ")");
}

std::vector<std::string> ContactParameters::remarks() const
{
  std::vector<std::string> lines = notes;
  for (const std::string& warning : warnings)
  {
    lines.push_back("warning: " + warning);
  }
  return lines;
}

ContactParameters readContactParameters(const std::vector<ParameterSource>& sources, const FileSearch& search)
{
  NodeConfig config = readNodeConfig(readParameters(sources, search), "", search);
  ContactParameters& contact = config;
  return std::move(contact);
}
}  // namespace wheel_rail_contact
