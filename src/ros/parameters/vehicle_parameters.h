// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <functional>
#include <string>
#include <vector>

namespace wheel_rail_contact
{
/// Parameters of one of several wheelsets in a node.
struct WheelsetParameters
{
  std::string name;
  XmlRpc::XmlRpcValue values;  ///< as those of a node of its own
};

/// Splits the parameters of a node with the list `wheelsets`. Each wheelset has the common ones, and its own in the
/// group of its name above them. Wheelsets at most `neighbour_reach` apart by `wheelset_places` are neighbours, unless
/// the wheelset has a list of its own (rail_bending/neighbours).
/// @param parameters all parameters of the node
/// @param prefix text before each name in messages (the namespace of the node with '/')
/// @param contact_topic topic of the results of a wheelset
/// @return empty without the list
/// @throw std::invalid_argument for an invalid name, one that is given twice, or a list of another size.
std::vector<WheelsetParameters> wheelsetParameters(
    const XmlRpc::XmlRpcValue& parameters, const std::string& prefix,
    const std::function<std::string(const std::string& wheelset)>& contact_topic);
}  // namespace wheel_rail_contact
