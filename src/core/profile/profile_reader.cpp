// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/profile_reader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "core/profile/profile_file.h"
#include "core/profile/smoothing_spline.h"
#include "core/profile/standard_profile_table.h"

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

/// Extension of the path, in lower case.
std::string extensionOf(const std::string& path)
{
  return lowerCase(std::filesystem::path(path).extension().string());
}

bool isKnownExtension(const std::string& extension)
{
  constexpr std::array<const char*, 5> known{".prw", ".prr", ".whl", ".ban", ".csv"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

/// Extension of the path, in lower case.
/// @throw ProfileError if the extension is unknown or belongs to the other kind of profile.
std::string checkedExtension(const std::string& path, ProfileKind kind)
{
  std::string extension = extensionOf(path);
  const bool of_wheel = extension == ".prw" || extension == ".whl";
  const bool of_rail = extension == ".prr" || extension == ".ban";
  if (!isKnownExtension(extension))
  {
    throw ProfileError(path, 0,
                       "neither the name of a standard profile (" + listOfStandardProfiles() +
                           ") nor a .prw, .prr, .whl, .ban or .csv file");
  }
  if (kind == ProfileKind::wheel ? of_rail : of_wheel)
  {
    throw ProfileError(path, 0, "extension " + extension + " does not belong to a " + nameOf(kind) + " profile");
  }
  return extension;
}

FileProfile readContent(ProfileFile& file, const std::string& extension, ProfileKind kind)
{
  if (extension == ".csv")
  {
    return readCsv(file);
  }
  return extension[1] == 'p' ? readSimpack(file, kind) : readMiniProf(file, kind);
}

/// Moves a curve of cubic sections vertically to make it pass through the origin. The curve must cross y = 0.
void setHeightFromTape(std::vector<ProfileSection>& sections)
{
  const Profile curve("", sections);
  double low = 0.0;
  double high = curve.length();
  for (int halving = 0; halving < 60; ++halving)
  {
    const double middle = 0.5 * (low + high);
    (curve.at(middle).y < 0.0 ? low : high) = middle;
  }
  const double height = curve.at(low).z;
  for (ProfileSection& section : sections)
  {
    std::get<CubicSection>(section.law).z[0] -= height;
  }
}
}  // namespace

Profile loadProfile(const std::string& name_or_path, ProfileKind kind, const ProfileReading& reading)
{
  const StandardProfile* standard = findStandardProfile(name_or_path);
  if (standard == nullptr)
  {
    return readProfile(name_or_path, kind, reading);
  }
  if (!fits(standard->kind, kind))
  {
    throw std::invalid_argument("profile '" + name_or_path + "' belongs to a " + nameOf(standard->kind) + "; a " +
                                nameOf(kind) + " profile is required");
  }
  if (reading.mirror)
  {
    throw std::invalid_argument("mirror = true applies to files, not to the standard profile '" + name_or_path + "'");
  }
  return standard->make();
}

namespace
{
Profile profileOf(const std::string& path, const ProfileFile& file, FileProfile content, ProfileKind kind,
                  const ProfileReading& reading)
{
  for (FilePoint& point : content.points)
  {
    point.point.y *= reading.mirror ? -1 : 1;
  }
  const std::vector<SampledPoint> points = orderedPoints(file, content, kind);
  const double expected_noise = reading.noise.value_or(content.noise);
  std::vector<ProfileSection> sections =
      expected_noise != 0.0 ? smoothingSpline(points, expected_noise) : interpolatingSpline(points);
  if (content.height_from_tape)
  {
    setHeightFromTape(sections);
  }
  return {std::filesystem::path(path).filename().string(), sections};
}
}  // namespace

Profile readProfile(const std::string& path, ProfileKind kind, const ProfileReading& reading)
{
  const std::string extension = checkedExtension(path, kind);
  ProfileFile file(path);
  return profileOf(path, file, readContent(file, extension, kind), kind, reading);
}

FileSlice readSlice(const std::string& path, const ProfileReading& reading)
{
  constexpr ProfileKind kind = ProfileKind::rail_section;
  const bool known = isKnownExtension(extensionOf(path));
  const std::string extension = known ? checkedExtension(path, kind) : "";
  ProfileFile file(path);
  const FileProfile content = known ? readContent(file, extension, kind) : readTwoColumns(file);
  const bool runs_outward = !content.points.empty() && content.points.front().point.y < content.points.back().point.y;
  return {profileOf(path, file, content, kind, reading), runs_outward == reading.mirror};
}
}  // namespace wheel_rail_contact::core
