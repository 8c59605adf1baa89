// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/node_parameters.h"

#include <ros/package.h>
#include <ros/param.h>

#include <filesystem>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace wheel_rail_contact
{
namespace
{
std::string digits(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}

YAML::Node listToYaml(const XmlRpc::XmlRpcValue& value)
{
  YAML::Node node(YAML::NodeType::Sequence);
  int i = 0;  // XmlRpcValue has iterators for groups only
  while (i < value.size())
  {
    node.push_back(toYaml(value[i++]));
  }
  return node;
}

YAML::Node groupToYaml(XmlRpc::XmlRpcValue& value)
{
  YAML::Node node(YAML::NodeType::Map);
  for (auto& entry : value)
  {
    node.force_insert(entry.first, toYaml(entry.second));  // no search for the name: all names differ
  }
  return node;
}
}  // namespace

YAML::Node toYaml(XmlRpc::XmlRpcValue value)
{
  using XmlRpc::XmlRpcValue;
  switch (value.getType())
  {
    case XmlRpcValue::TypeInvalid:
      return YAML::Node(YAML::NodeType::Null);
    case XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool&>(value) ? "true" : "false");
    case XmlRpcValue::TypeInt:
      return YAML::Node(std::to_string(static_cast<int&>(value)));
    case XmlRpcValue::TypeDouble:
      return YAML::Node(digits(static_cast<double&>(value)));
    case XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string&>(value));
    case XmlRpcValue::TypeArray:
      return listToYaml(value);
    case XmlRpcValue::TypeStruct:
      return groupToYaml(value);
    default:
      throw std::invalid_argument("parameters: dates and binary data are not permitted");
  }
}

NodeConfig readNodeParameters(const ros::NodeHandle& private_nh)
{
  const std::string& name = private_nh.getNamespace();
  XmlRpc::XmlRpcValue value;
  ros::param::get(name, value);  // without any parameter of the node the value, and the tree, stay empty
  return readNodeConfig(parameterTree(toYaml(value)), name + "/",
                        {std::filesystem::current_path().string(), ros::package::getPath});
}
}  // namespace wheel_rail_contact
