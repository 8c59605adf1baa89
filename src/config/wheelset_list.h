// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "config/parameter_reader.h"

namespace wheel_rail_contact
{
/// Names of the parameters of a node with several wheelsets.
namespace wheelset_list
{
constexpr const char* names = "wheelsets";
constexpr const char* places = "wheelset_places";
constexpr const char* reach = "neighbour_reach";
}  // namespace wheelset_list

/// True for a name that ROS permits for a topic, and that is not private.
bool isTopic(const std::string& name);

/// The wheelsets of a node, and how they are arranged.
struct WheelsetList
{
  std::vector<std::string> names;
  std::vector<double> places;  ///< along the track [m]; empty: unknown
  double reach = 0;            ///< largest distance of neighbours [m]
};

/// Reads them.
/// @throw std::invalid_argument for an invalid name, one that is given twice, or a list of another size.
WheelsetList readWheelsetList(ParameterReader& reader);
}  // namespace wheel_rail_contact
