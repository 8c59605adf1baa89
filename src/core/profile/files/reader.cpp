// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/profile_reader.h"

#include <filesystem>
#include <stdexcept>
#include <tuple>

#include "core/profile/files/steps.h"
#include "core/profile/standard/table.h"

namespace wheel_rail_contact::core
{
namespace
{
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
  if (!fits(standard.kind, kind))
  {
    throw std::invalid_argument("profile '" + name + "' belongs to a " + nameOf(standard.kind) + "; a " + nameOf(kind) +
                                " profile is required");
  }
  if (!(reading == ProfileReading{}))
  {
    throw std::invalid_argument(
        "options (unit, y, z, origin, shift, rotate, mirror, smoothing) apply to files, not to the standard profile '" +
        name + "'");
  }
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

bool operator==(const ProfileReading& a, const ProfileReading& b)
{
  const auto members = [](const ProfileReading& r)
  { return std::tie(r.smoothing, r.unit, r.y, r.z, r.origin, r.shift_y, r.shift_z, r.rotate, r.mirror); };
  return members(a) == members(b);
}

DescribedProfile describedProfile(const std::string& name_or_path, ProfileKind kind, const ProfileReading& reading)
{
  if (const StandardProfile* standard = findStandardProfile(name_or_path))
  {
    return describedStandard(*standard, kind, reading);
  }
  if (!std::filesystem::exists(name_or_path))
  {
    throw FileError(name_or_path, 0,
                    "neither the name of a standard profile (" + listOfStandardProfiles() + ") nor a file");
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
