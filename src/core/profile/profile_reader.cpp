// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/profile_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <tuple>
#include <vector>

#include "core/profile/file_axes.h"
#include "core/profile/file_profile.h"
#include "core/profile/profile_curve.h"
#include "core/profile/profile_error.h"
#include "core/profile/profile_order.h"
#include "core/profile/profile_placing.h"
#include "core/profile/profile_report.h"
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

std::vector<FittedPoint> fittedPoints(const std::vector<FilePoint>& points)
{
  std::vector<FittedPoint> fitted;
  std::transform(points.begin(), points.end(), std::back_inserter(fitted),
                 [](const FilePoint& p) {
                   return FittedPoint{p.point.y, p.point.z};
                 });
  return fitted;
}

/// @throw std::invalid_argument if an option is out of range.
void checkReading(const ProfileReading& reading)
{
  constexpr double farthest = 1.0;  // [m]
  const auto require = [](bool rule, const char* text)
  {
    if (!rule)
    {
      throw std::invalid_argument(std::string("profile: ") + text);
    }
  };
  require(!reading.smoothing || (*reading.smoothing >= 0 && *reading.smoothing <= max_spline_noise),
          "smoothing must be 0 to 1e-4 m");
  require(!reading.unit || (*reading.unit > 0 && std::isfinite(*reading.unit)), "unit must be a positive length");
  require(std::abs(reading.shift_y) <= farthest && std::abs(reading.shift_z) <= farthest, "shift must be at most 1 m");
  require(std::isfinite(reading.rotate), "rotate must be finite");
}

/// Points in order. A refusal of their shape is completed by a hint.
std::vector<FilePoint> orderedOrHint(const TextFile& file, const PlacedPoints& placed, ProfileKind kind,
                                     const std::function<std::string()>& hint)
{
  try
  {
    return orderedPoints(file, placed.points, kind);
  }
  catch (const TextError& error)
  {
    const std::string text = hint();
    file.refuse(error.line(), error.reason() + (text.empty() ? "" : "; " + text));
  }
}

DescribedProfile profileOf(const TextFile& file, const FileProfile& content, ProfileKind kind,
                           const ProfileReading& reading)
{
  checkReading(reading);
  const FileAxes axes = requiredAxes(file, content, kind, reading);
  const PlacedPoints placed = placedPoints(file, content, kind, axes, reading);
  std::vector<FilePoint> ordered =
      orderedOrHint(file, placed, kind, [&] { return hintFor(file, content, kind, axes, reading); });
  ProfileReport report;
  report.remark = content.remark;
  const std::vector<ProfileSection> sections = curveThrough(file, content, axes.unit, reading, ordered, report);
  report.format = content.format;
  report.points = ordered.size();
  report.omitted = content.points.size() - ordered.size();
  report.unit = axes.unit;
  report.y = axes.y;
  report.z = axes.z;
  report.moved_y = placed.moved_y;
  report.moved_z = placed.moved_z;
  Profile profile(std::filesystem::path(file.path()).filename().string(), sections);
  report.text = reportText(profile, report);
  return {std::move(profile), std::move(report), fittedPoints(ordered)};
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
  return withProfileError(
      [&]
      {
        TextFile file(path);
        const FileProfile content = readContent(file, kind);
        return profileOf(file, content, kind, reading);
      });
}
}  // namespace

ProfileError::ProfileError(const std::string& file, std::size_t line, const std::string& reason)
    : std::runtime_error(TextError(file, line, reason).what()), file_(file), line_(line), reason_(reason)
{
}

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
    throw ProfileError(name_or_path, 0,
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

FileSlice readSlice(const std::string& path, const ProfileReading& reading)
{
  constexpr ProfileKind kind = ProfileKind::rail_section;
  TextFile file(path);
  FileProfile content = readContent(file, kind);
  const auto [left, right] =
      std::minmax_element(content.points.begin(), content.points.end(),
                          [](const FilePoint& a, const FilePoint& b) { return a.point.y < b.point.y; });
  if (content.points.empty())
  {
    file.refuse(0, "has no points");
  }
  if (!content.unit)
  {
    content.unit = right->point.y - left->point.y < 1 ? 1 : 1e-3;
  }
  content.y = content.y.value_or(ProfileReading::Y::outward);
  content.z = content.z.value_or(ProfileReading::Z::down);
  const bool runs_outward = (content.points.front().point.y < content.points.back().point.y) ==
                            (reading.y.value_or(*content.y) == ProfileReading::Y::outward);
  DescribedProfile described = profileOf(file, content, kind, reading);
  return {std::move(described.profile), runs_outward == reading.mirror, described.report.text};
}
}  // namespace wheel_rail_contact::core
