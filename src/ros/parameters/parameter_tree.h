// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <string>

namespace wheel_rail_contact
{
/// Parameters by their full name, groups separated by '/': "track/gauge". Every value is a scalar, a list or null.
using ParameterTree = std::map<std::string, YAML::Node>;

/// Parameters of a YAML document; an empty document gives none.
/// @throw std::invalid_argument if it is no map of named groups and values, or gives a name twice.
ParameterTree parameterTree(const YAML::Node& document);

/// Parameters of a YAML file.
/// @throw std::invalid_argument naming the file if it cannot be read or is no map of parameters.
ParameterTree readParameterFile(const std::string& file);

/// A namespace of the parameter server as a YAML document. Numbers keep their value to the last bit (17 digits), so a
/// parameter is the same whether it comes from the server or from the file.
/// @throw std::invalid_argument for values that parameters of this package never have (dates, binary data).
YAML::Node toYaml(const XmlRpc::XmlRpcValue& value);

/// `upper` laid over `base`: its values win.
ParameterTree overlay(const ParameterTree& base, const ParameterTree& upper);
}  // namespace wheel_rail_contact
