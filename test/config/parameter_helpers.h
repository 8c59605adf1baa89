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

/// Writes points of a profile [m] in the folder of read(), after a change of their axes.
inline void writePoints(
    const std::string& name, const core::Profile& profile, const std::string& titles = "",
    const std::function<void(double&, double&)>& change = [](double&, double&) {})
{
  std::ofstream file(testing::TempDir() + name);
  file.precision(12);
  file << titles;
  for (int i = 0; i <= 400; ++i)
  {
    core::CurvePoint p = profile.at(profile.length() * i / 400);
    change(p.y, p.z);
    file << p.y << "," << p.z << "\n";
  }
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

/// Expects values of parameters to be refused with name and value. @param text lines "name: value | value"
inline void expectValuesRefused(const std::string& text)
{
  std::istringstream lines(text);
  for (std::string name, values; std::getline(lines >> std::ws, name, ':') && std::getline(lines, values);)
  {
    for (std::size_t begin = 1, end = 0; end != std::string::npos; begin = end + 3)
    {
      end = values.find(" | ", begin);
      const std::string value = values.substr(begin, end - begin);
      const YAML::Node node = YAML::Load(value);
      const std::string message = refusal(overlay(defaults(), {{name, node}}));
      EXPECT_TRUE(contains(message, "/contact_node/" + name + " = ")) << value;
      EXPECT_TRUE(contains(message, node.IsScalar() ? node.Scalar() : value));
    }
  }
}
}  // namespace wheel_rail_contact
