// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/node_parameters.h"

#include <ros/names.h>
#include <ros/param.h>

#include <sstream>
#include <stdexcept>
#include <vector>

#include "wheel_rail_contact/core/track.h"

namespace simulate_wheelset
{
namespace
{
std::string fullName(const std::string& node, const std::string& parameter)
{
  return ros::names::resolve(node) + "/" + parameter;
}
/// A radius on the parameter server; `otherwise` if it has none [m].
double radius(const std::string& name, double otherwise)
{
  double value = otherwise;
  std::string text;  // 460e-3 in a YAML file is a text for the parameter server, and a number for the node
  if (ros::param::get(name, text))
  {
    std::istringstream(text) >> value;
  }
  else if (!ros::param::get(name, value) && ros::param::has(name))
  {
    value = 0;
  }
  if (!(value > 0))
  {
    throw std::runtime_error(name + " must be a number > 0");
  }
  return value;
}
}  // namespace

void requireWheelLoads(const std::string& node)
{
  const std::string balance = fullName(node, "wheelset/balance"), expected = "wheel_loads";
  const std::string value = ros::param::param(balance, expected);
  if (value != expected)
  {
    throw std::runtime_error(balance + " = " + value + " must be " + expected + ": the load of this program is for it");
  }
  const std::string free = fullName(node, "wheelset/free");
  std::vector<std::string> solved;
  if (ros::param::get(free, solved) && solved.empty())
  {
    throw std::runtime_error(free + " = [] must be [z, roll]: this program does not integrate height and roll");
  }
}

double rollingRadiusOf(const std::string& node)
{
  const double of_both =
      radius(fullName(node, "wheelset/rolling_radius"), wheel_rail_contact::core::WheelsetConfig().meanRadius());
  return 0.5 * (radius(fullName(node, "wheel/left/rolling_radius"), of_both) +
                radius(fullName(node, "wheel/right/rolling_radius"), of_both));
}
}  // namespace simulate_wheelset
