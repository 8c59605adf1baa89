// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/vehicle_parameters.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "config/wheelset_list.h"
#include "ros/parameters/node_parameters.h"

namespace wheel_rail_contact
{
namespace
{
using XmlRpc::XmlRpcValue;

constexpr double rounding = 1e-9;  ///< of the difference of two places [m]

/// Puts the values of `upper` above those of `base`, group by group.
void putAbove(XmlRpcValue& base, XmlRpcValue& upper)
{
  for (auto& [name, value] : upper)
  {
    const bool are_groups = value.getType() == XmlRpcValue::TypeStruct && base.hasMember(name) &&
                            base[name].getType() == XmlRpcValue::TypeStruct;
    are_groups ? putAbove(base[name], value) : static_cast<void>(base[name] = value);
  }
}

/// Text of a parameter in a group; empty without it.
std::string groupText(XmlRpcValue& values, const char* group, const char* name)
{
  XmlRpcValue none;
  XmlRpcValue& in = values.hasMember(group) ? values[group] : none;
  const bool is_text = in.hasMember(name) && in[name].getType() == XmlRpcValue::TypeString;
  return is_text ? static_cast<std::string>(in[name]) : "";
}

/// Refuses a frame that another wheelset broadcasts, too: tf would show it at both places in turn.
void refuseSharedFrames(XmlRpcValue& wheelset, std::set<std::string>& frames, ParameterReader& reader)
{
  const std::string own = groupText(wheelset, "wheelset", "frame");
  reader.refuseIf(!own.empty() && !frames.insert(own).second, "wheelset/frame", "another one for each wheelset");
  const bool moves = !groupText(wheelset, "track", "publish_track_frame").empty();
  reader.refuseIf(moves && !frames.insert(groupText(wheelset, "track", "frame")).second, "track/publish_track_frame",
                  "empty, unless each wheelset has its own track/frame");
}

/// Entries of rail_bending/neighbours of a wheelset.
XmlRpcValue neighboursOf(std::size_t wheelset, const WheelsetList& list,
                         const std::function<std::string(const std::string&)>& contact_topic)
{
  XmlRpcValue neighbours;
  neighbours.setSize(0);
  for (std::size_t i = 0; i < list.places.size(); ++i)
  {
    const double distance = std::abs(list.places[i] - list.places[wheelset]);
    if (i != wheelset && distance <= list.reach + rounding)
    {
      XmlRpcValue neighbour;
      neighbour["topic"] = contact_topic(list.names[i]);
      neighbour["distance"] = distance;
      neighbours[neighbours.size()] = neighbour;
    }
  }
  return neighbours;
}
}  // namespace

std::vector<WheelsetParameters> wheelsetParameters(
    const XmlRpcValue& parameters, const std::string& prefix,
    const std::function<std::string(const std::string& wheelset)>& contact_topic)
{
  XmlRpcValue values = parameters;  // toYaml() states why
  if (values.getType() != XmlRpcValue::TypeStruct || !values.hasMember(wheelset_list::names))
  {
    return {};
  }
  XmlRpcValue common, own;
  ParameterReader reader(parameterTree(toYaml(values)), prefix);
  const WheelsetList list = readWheelsetList(reader);
  for (auto& [name, value] : values)
  {
    if (name != wheelset_list::names && name != wheelset_list::places && name != wheelset_list::reach)
    {
      (std::count(list.names.begin(), list.names.end(), name) > 0 ? own : common)[name] = value;
    }
  }
  std::vector<WheelsetParameters> wheelsets;
  std::set<std::string> frames;
  for (std::size_t i = 0; i < list.names.size(); ++i)
  {
    const std::string& name = list.names[i];
    XmlRpcValue& of_one = wheelsets.emplace_back(WheelsetParameters{name, common}).values;
    if (list.reach > 0)
    {
      XmlRpcValue& bending = of_one["rail_bending"];
      reader.refuseIf(bending.valid() && bending.getType() != XmlRpcValue::TypeStruct, "rail_bending", "a group");
      reader.refuseIf(bending.hasMember("neighbours") && bending["neighbours"].getType() == XmlRpcValue::TypeArray &&
                          bending["neighbours"].size() > 0,
                      "rail_bending/neighbours", "[] beside neighbour_reach, or in the group of a wheelset");
      bending["neighbours"] = neighboursOf(i, list, contact_topic);
    }
    if (own.hasMember(name))
    {
      reader.refuseIf(own[name].getType() != XmlRpcValue::TypeStruct, name, "a group: the parameters of this wheelset");
      putAbove(of_one, own[name]);
    }
    refuseSharedFrames(of_one, frames, reader);
  }
  return wheelsets;
}
}  // namespace wheel_rail_contact
