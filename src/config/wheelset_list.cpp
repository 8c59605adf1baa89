// SPDX-License-Identifier: BSD-3-Clause
#include "config/wheelset_list.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace wheel_rail_contact
{
namespace
{
bool isWheelsetName(const std::string& name)
{
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !name.empty() && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c)
                     { return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}
}  // namespace

WheelsetList readWheelsetList(ParameterReader& reader)
{
  WheelsetList list;
  reader.read(wheelset_list::names, list.names);
  std::set<std::string> names;
  for (const std::string& name : list.names)
  {
    reader.refuseIf(!isWheelsetName(name), wheelset_list::names,
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
