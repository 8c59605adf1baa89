// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/profile_reader.h"

#include <filesystem>
#include <tuple>

#include "core/option_check.h"
#include "core/profile/files/steps.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Standard profile and its name in parameters.
struct StandardProfile
{
  const char* name;
  ProfileKind kind;   ///< wheel or rail
  Profile (*make)();  ///< makes the profile
};

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

bool fits(ProfileKind standard, ProfileKind kind)
{
  return (standard == ProfileKind::wheel) == (kind == ProfileKind::wheel);
}

const char* nameOf(ProfileKind kind)
{
  return kind == ProfileKind::wheel ? "wheel" : "rail";
}

DescribedProfile describedStandard(const StandardProfile& standard, ProfileKind kind, const ProfileReading& reading)
{
  const std::string name = standard.name;
  refuseIf(!fits(standard.kind, kind), "profile '" + name + "' belongs to a " + nameOf(standard.kind) + "; a " +
                                           nameOf(kind) + " profile is required");
  refuseIf(
      !(reading == ProfileReading{}),
      "options (unit, y, z, origin, shift, rotate, mirror, smoothing) apply to files, not to the standard profile '" +
          name + "'");
  ProfileReport report;
  report.text = "standard profile";
  return {standard.make(), report, {}};
}

DescribedProfile readDescribed(const std::string& path, ProfileKind kind, const ProfileReading& reading)
{
  TextFile file(path);
  return profileOf(file, readContent(file, kind), kind, reading);
}
}  // namespace

std::vector<std::string> standardProfileNames(ProfileKind kind)
{
  std::vector<std::string> names;
  for (const StandardProfile& standard : standard_profiles)
  {
    if (fits(standard.kind, kind))
    {
      names.emplace_back(standard.name);
    }
  }
  return names;
}

bool operator==(const ProfileReading& a, const ProfileReading& b)
{
  const auto members = [](const ProfileReading& r)
  { return std::tie(r.smoothing, r.unit, r.y, r.z, r.origin, r.shift_y, r.shift_z, r.rotate, r.mirror); };
  return members(a) == members(b);
}

DescribedProfile describedProfile(const std::string& name_or_path, ProfileKind kind, const ProfileReading& reading)
{
  for (const StandardProfile& standard : standard_profiles)
  {
    if (name_or_path == standard.name)
    {
      return describedStandard(standard, kind, reading);
    }
  }
  if (!std::filesystem::exists(name_or_path))
  {
    throw FileError(name_or_path, 0,
                    "neither the name of a standard profile (" +
                        joined(standardProfileNames(ProfileKind::wheel), ", ") + ", " +
                        joined(standardProfileNames(ProfileKind::rail), ", ") + ") nor a file");
  }
  return readDescribed(name_or_path, kind, reading);
}

Profile loadProfile(const std::string& name_or_path, ProfileKind kind, const ProfileReading& reading)
{
  return describedProfile(name_or_path, kind, reading).profile;
}

Profile readProfile(const std::string& path, ProfileKind kind, const ProfileReading& reading)
{
  return readDescribed(path, kind, reading).profile;
}
}  // namespace wheel_rail_contact::core
