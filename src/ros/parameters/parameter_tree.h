// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <string>

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

/// A namespace of the parameter server as a YAML document. Numbers are written with 17 digits and keep their exact
/// value: a parameter from the server is identical to one from the file.
/// The value is a copy, because before ROS 1.15 an XmlRpcValue gives no access to its content if it is const.
/// @throw std::invalid_argument for dates and binary data.
YAML::Node toYaml(XmlRpc::XmlRpcValue value);

/// Union of both trees. For names in both, the value is that of `upper`. A group of `upper`
/// replaces a value of `base` with its name, and a value replaces a group.
ParameterTree overlay(const ParameterTree& base, const ParameterTree& upper);
}  // namespace wheel_rail_contact
