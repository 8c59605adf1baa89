// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../refusal.h"
#include "config/node_config.h"

namespace wheel_rail_contact
{
inline std::string packageFile(const std::string& name)
{
  return std::string(PACKAGE_FOLDER "/") + name;
}

/// Only this package is found.
inline FileSearch search()
{
  return {testing::TempDir(),
          [](const std::string& package) { return package == "wheel_rail_contact" ? PACKAGE_FOLDER : ""; }};
}

inline ParameterTree defaults()
{
  return readParameterFile(packageFile("config/default.yaml"));
}

inline ParameterTree with(const std::string& yaml)
{
  return overlay(defaults(), parameterTree(YAML::Load(yaml)));
}

inline NodeConfig read(const ParameterTree& tree)
{
  return readNodeConfig(tree, "/contact_node/", search());
}

/// Message with which a tree is refused; "accepted" if it is not.
inline std::string refusal(const ParameterTree& tree)
{
  return refusalOf([&] { read(tree); });
}

struct Mistake
{
  const char* yaml;   ///< replaces values of config/default.yaml
  const char* name;   ///< text that the message must contain
  const char* value;  ///< text that the message must contain
};

/// Expects each mistake to be refused with its name and value.
inline void expectRefused(const std::vector<Mistake>& mistakes)
{
  for (const Mistake& mistake : mistakes)
  {
    const std::string message = refusal(with(mistake.yaml));
    EXPECT_TRUE(contains(message, std::string("/contact_node/") + mistake.name) && contains(message, mistake.value))
        << mistake.yaml << "\n  gave: " << message;
  }
}
}  // namespace wheel_rail_contact
