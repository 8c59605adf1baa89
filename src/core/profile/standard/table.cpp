// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/standard/table.h"

#include <algorithm>
#include <iterator>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr StandardProfile standard_profiles[] = {{"S1002", ProfileKind::wheel, s1002Wheel},
                                                 {"LMA", ProfileKind::wheel, lmaWheel},
                                                 {"cone_1_20", ProfileKind::wheel, [] { return coneWheel(1.0 / 20); }},
                                                 {"cone_1_40", ProfileKind::wheel, [] { return coneWheel(1.0 / 40); }},
                                                 {"54E1", ProfileKind::rail, rail54E1},
                                                 {"54E3", ProfileKind::rail, rail54E3},
                                                 {"56E1", ProfileKind::rail, rail56E1},
                                                 {"60E1", ProfileKind::rail, rail60E1},
                                                 {"60E2", ProfileKind::rail, rail60E2},
                                                 {"UIC60_manchester", ProfileKind::rail, railUic60Manchester}};
}  // namespace

const StandardProfile* findStandardProfile(const std::string& name)
{
  const StandardProfile* found = std::find_if(std::begin(standard_profiles), std::end(standard_profiles),
                                              [&](const StandardProfile& standard) { return name == standard.name; });
  return found == std::end(standard_profiles) ? nullptr : found;
}

std::string listOfStandardProfiles()
{
  std::string list;
  for (const StandardProfile& standard : standard_profiles)
  {
    list += (list.empty() ? "" : ", ") + std::string(standard.name);
  }
  return list;
}

std::vector<std::string> standardProfileNames(ProfileKind kind)
{
  std::vector<std::string> names;
  for (const StandardProfile& standard : standard_profiles)
  {
    if ((standard.kind == ProfileKind::wheel) == (kind == ProfileKind::wheel))
    {
      names.emplace_back(standard.name);
    }
  }
  return names;
}
}  // namespace wheel_rail_contact::core
