// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include <memory>
#include <stdexcept>

#include "examples/simulate_wheelset/in_process_contact.h"
#include "wheel_rail_contact/core/profile_reader.h"
#include "wheel_rail_contact/core/track.h"

namespace simulate_wheelset
{
namespace core = wheel_rail_contact::core;

namespace
{
using Config = core::ContactModelConfig;

std::shared_ptr<const core::Profile> profile(const std::string& name, core::ProfileKind kind)
{
  return std::make_shared<const core::Profile>(core::loadProfile(name, kind));
}

/// Sets one parameter. The line comes last, because it needs the gauge.
void set(const std::string& name, const YAML::Node& value, Config& config, std::string& line)
{
  if (name == "wheel/profile")
  {
    config.wheel_profile = profile(value.as<std::string>(), core::ProfileKind::wheel);
  }
  else if (name == "rail/profile")
  {
    config.rail_profile = profile(value.as<std::string>(), core::ProfileKind::rail);
  }
  else if (name == "track/line")
  {
    line = value.as<std::string>();
  }
  else if (name == "track/gauge")
  {
    config.track.gauge = value.as<double>();
  }
  else if (name == "wheelset/rolling_radius")
  {
    config.wheelset.rolling_radius = value.as<double>();
  }
  else if (name == "contact/tolerance")
  {
    config.contact.tolerance = value.as<double>();
  }
  else
  {
    throw std::invalid_argument("parameter " + name + " is not supported with --contact in_process");
  }
}

void read(const YAML::Node& document, Config& config, std::string& line)
{
  if (!document.IsMap())
  {
    throw std::invalid_argument("the file must be a map of groups");
  }
  for (const auto& group : document)
  {
    if (!group.second.IsMap())
    {
      throw std::invalid_argument("group " + group.first.as<std::string>() + " must be a map of names and values");
    }
    for (const auto& pair : group.second)
    {
      const std::string name = group.first.as<std::string>() + "/" + pair.first.as<std::string>();
      try
      {
        set(name, pair.second, config, line);
      }
      catch (const YAML::Exception&)
      {
        throw std::invalid_argument("parameter " + name + " = " + YAML::Dump(pair.second) + " has the wrong type");
      }
    }
  }
}
}  // namespace

core::ContactModelConfig readContactParameters(const std::string& file)
{
  Config config;
  config.wheel_profile = profile("S1002", core::ProfileKind::wheel);
  config.rail_profile = profile("60E1", core::ProfileKind::rail);
  if (file.empty())
  {
    return config;
  }
  try
  {
    std::string line;
    read(YAML::LoadFile(file), config, line);
    if (!line.empty())
    {
      config.track.line = std::make_shared<const core::TrackLine>(core::readTrackLine(line, config.track.gauge));
    }
  }
  catch (const std::exception& error)
  {
    throw std::invalid_argument(file + ": " + error.what());
  }
  return config;
}
}  // namespace simulate_wheelset
