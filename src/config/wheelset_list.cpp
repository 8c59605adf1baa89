// SPDX-License-Identifier: BSD-3-Clause
#include "config/wheelset_list.h"

#include <algorithm>
#include <set>

namespace wheel_rail_contact
{
bool isTopic(const std::string& name)
{
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_permitted = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '/'; };
  return !name.empty() && (is_letter(name[0]) || name[0] == '/') && std::all_of(name.begin(), name.end(), is_permitted);
}

WheelsetList readWheelsetList(ParameterReader& reader)
{
  WheelsetList list;
  reader.read(wheelset_list::names, list.names);
  std::set<std::string> names;
  for (const std::string& name : list.names)
  {
    reader.refuseIf(!isTopic(name) || name.find('/') != std::string::npos, wheelset_list::names,
                    "a list of names of letters, digits and _ that begin with a letter: '" + name + "' is none");
    reader.refuseIf(!names.insert(name).second, wheelset_list::names,
                    "a list of different names: '" + name + "' is given twice");
  }
  reader.read(wheelset_list::places, list.places);
  reader.refuseIf(!list.places.empty() && list.places.size() != list.names.size(), wheelset_list::places,
                  "[] or a list with a place for each of the wheelsets");
  reader.read(wheelset_list::reach, rules::not_negative, list.reach);
  reader.refuseIf(list.reach > 0 && list.places.empty(), wheelset_list::reach, "0 without wheelset_places");
  return list;
}
}  // namespace wheel_rail_contact
