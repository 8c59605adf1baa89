// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

#include "wheel_rail_contact/config_file.h"

namespace wheel_rail_contact
{
/// Parameters by full name, with groups separated by '/': "track/gauge". Each value is a scalar, a list or null.
using ParameterTree = std::map<std::string, YAML::Node>;

/// Parameters of a YAML document; none for an empty document.
/// @throw std::invalid_argument if the document is not a map of named groups and values, contains a name twice, or
/// exceeds the limits of depth or size.
ParameterTree parameterTree(const YAML::Node& document);

/// Parameters of a YAML file.
/// @throw std::invalid_argument with the file name if the file cannot be read or parameterTree() throws.
ParameterTree readParameterFile(const std::string& file);

/// Union of both trees. For names in both, the value is that of `upper`. A group of `upper`
/// replaces a value of `base` with its name, and a value replaces a group.
ParameterTree overlay(const ParameterTree& base, const ParameterTree& upper);

/// Parameters of several sources, each applied over those before.
/// @throw std::invalid_argument for a source that cannot be read.
ParameterTree readParameters(const std::vector<ParameterSource>& sources, const FileSearch& search);
}  // namespace wheel_rail_contact
