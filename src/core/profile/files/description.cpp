// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/option_check.h"
#include "core/profile/curve/measures.h"
#include "core/profile/files/steps.h"
#include "core/text/formatted.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double micrometre = 1e-6;      ///< [m]
constexpr double least_movement = 1e-9;  ///< shorter ones are rounding [m]
/// Ratio of length and width of a missing range from which it is the side of a head or a wheel, which carries nothing.
constexpr double steep = 3;

std::string micrometres(double length)
{
  return formatted("%.2g um", length / micrometre);
}

/// Range of y in which points of a profile are missing [m].
struct MissingRange
{
  double y_first, y_last;
  double length;  ///< along the curve [m]
};

/// Ranges in which points are missing, from the gauge side.
std::vector<MissingRange> missingRanges(const Profile& profile)
{
  std::vector<MissingRange> ranges;
  const std::vector<double>& places = profile.discontinuities();
  bool missing_before = false;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    const bool missing = profile.errorAt(0.5 * (places[i] + places[i + 1])).missing;
    if (missing && !missing_before)
    {
      ranges.push_back({profile.at(places[i]).y, 0, 0});
    }
    if (missing)
    {
      ranges.back().y_last = profile.at(places[i + 1]).y;
      ranges.back().length += places[i + 1] - places[i];
    }
    missing_before = missing;
  }
  return ranges;
}

/// One line with what was understood of a file.
std::string reportText(const Profile& profile, const ProfileReport& report)
{
  std::ostringstream text;
  text << report.format << ", " << report.points << " points";
  if (report.omitted > 0)
  {
    text << " (" << report.omitted << " omitted: closer than 0.05 mm, running back, or beside the head)";
  }
  text << ", unit " << nameOfLength(report.unit) << ", y "
       << (report.y == ProfileReading::Y::outward ? "outward" : "inward") << ", z "
       << (report.z == ProfileReading::Z::up ? "up" : "down");
  if (std::hypot(report.moved_y, report.moved_z) > least_movement)
  {
    text << ", moved by " << millimetres(report.moved_y) << " outward and " << millimetres(report.moved_z) << " up";
  }
  text << ", noise " << (report.noise ? micrometres(*report.noise) : "not known (too few points)");
  text << (report.smoothing > 0 ? ", smoothed for " + micrometres(report.smoothing) : ", not smoothed");
  for (const MissingRange& range : missingRanges(profile))
  {
    if (!(range.length > steep * std::abs(range.y_last - range.y_first)))
    {
      text << ", points missing over " << millimetres(range.length) << " from y = " << millimetres(range.y_first)
           << " to " << millimetres(range.y_last);
    }
  }
  if (!report.remark.empty())
  {
    text << ", " << report.remark;
  }
  return text.str();
}

/// Two remarks, either of which may be empty.
std::string sentence(const std::string& first, const std::string& second)
{
  return first + (first.empty() || second.empty() ? "" : ", ") + second;
}

/// The inclination of the head of a rail, in words; empty if it is upright or not known.
std::string inclinationText(const std::optional<double>& inclination)
{
  constexpr double least = 0.01;  // the sides of new rails are less askew [rad]
  return !inclination || std::abs(*inclination) < least
             ? ""
             : formatted("looks inclined by 1:%.3g %s", 1 / std::tan(std::abs(*inclination)),
                         *inclination > 0 ? "towards the track centre" : "to the field side");
}

/// The content and the options of a model, as if it had full size: all rules hold for it then.
void enlarge(FileProfile& content, ProfileReading& reading)
{
  content.magnification = 1 / reading.scale;
  for (SampledPoint& p : content.points)
  {
    p.y *= content.magnification;
    p.z *= content.magnification;
  }
  content.running_circle *= content.magnification;
  for (std::optional<double>* length : {&content.smoothing, &reading.smoothing, &reading.tape_circle})
  {
    if (*length)
    {
      **length *= content.magnification;
    }
  }
  reading.shift_y *= content.magnification;
  reading.shift_z *= content.magnification;
}

/// Curve of a spline in full size, reduced to a scale.
void reduce(double scale, std::vector<ProfileSection>& sections, std::vector<SampledPoint>& points)
{
  for (ProfileSection& section : sections)
  {
    auto& law = std::get<CubicSection>(section.law);
    for (int k = 0; k < 4; ++k)
    {
      law.y[k] *= std::pow(scale, 1 - k);
      law.z[k] *= std::pow(scale, 1 - k);
    }
    section.length *= scale;
    section.error.position *= scale;
    section.error.curvature /= scale;
  }
  for (SampledPoint& p : points)
  {
    p.y *= scale;
    p.z *= scale;
  }
}

/// End of a refusal: the scale of a model, or what makes points a model that are as narrow as those of one.
std::string modelHint(const FileProfile& content, const ProfileReading& reading)
{
  constexpr double least = 0.003, most = 0.040;  // width of the points of a model [m]
  const auto [left, right] = std::minmax_element(content.points.begin(), content.points.end(), isFartherInward);
  const double width = content.points.empty()
                           ? 0
                           : (right->y - left->y) * reading.scale * content.unit.value_or(reading.unit.value_or(0));
  return reading.scale < 1 ? formatted(" (lengths of the points of this 1:%.3g model in full size%s)",
                                       1 / reading.scale, width > most ? ": are the points those of full size?" : "")
         : width > least && width < most
             ? "; a model is recognised by its wheelset/rolling_radius and track/gauge (check_profile --scale)"
             : "";
}

/// @throw std::invalid_argument if an option is out of range.
void checkReading(const ProfileReading& reading)
{
  constexpr double farthest = 1.0;  // [m]
  const auto require = [](bool rule, const char* text) { refuseIf(!rule, std::string("profile: ") + text); };
  require(!reading.smoothing || (*reading.smoothing >= 0 && *reading.smoothing <= max_spline_noise),
          "smoothing must be 0 to 1e-4 m");
  require(!reading.unit || (*reading.unit > 0 && std::isfinite(*reading.unit)), "unit must be a positive length");
  require(std::abs(reading.shift_y) <= farthest && std::abs(reading.shift_z) <= farthest, "shift must be at most 1 m");
  require(std::isfinite(reading.rotate), "rotate must be finite");
  require(reading.scale > 0 && reading.scale <= 1, "scale must be above 0, at most 1");
}
}  // namespace

DescribedProfile profileOf(const TextFile& file, FileProfile content, ProfileKind kind, ProfileReading reading)
{
  checkReading(reading);
  const double scale = reading.scale;
  if (scale != 1)
  {
    enlarge(content, reading);
  }
  ProfileReport report;
  FramedPoints framed;
  std::vector<SampledPoint>& points = framed.placed.points;
  std::vector<ProfileSection> sections;
  try
  {
    framed = framedPoints(file, content, kind, reading);
    report.remark = sentence(content.remark, framed.placed.remark);
    sections = curveThrough(file, content, framed.axes.unit, reading, points, report);
  }
  catch (const FileError& error)
  {
    file.refuse(error.line(), error.reason() + modelHint(content, reading));
  }
  const std::string name = std::filesystem::path(file.path()).filename().string();
  if (kind == ProfileKind::rail)
  {
    report.inclination = railMeasures(Profile(name, sections)).inclination();
    report.remark = sentence(report.remark, inclinationText(report.inclination));
  }
  if (scale != 1)
  {
    reduce(scale, sections, points);
  }
  report.format = content.format;
  report.points = points.size();
  report.omitted = content.points.size() - points.size();
  report.unit = framed.axes.unit;
  report.y = framed.axes.y;
  report.z = framed.axes.z;
  report.moved_y = scale * framed.placed.moved_y;
  report.moved_z = scale * framed.placed.moved_z;
  report.noise = report.noise ? std::optional(scale * *report.noise) : std::nullopt;
  report.smoothing *= scale;
  Profile profile(name, sections);
  report.text = reportText(profile, report);
  std::vector<FittedPoint> fitted;
  fitted.reserve(points.size());
  for (const SampledPoint& p : points)
  {
    fitted.push_back({p.y, p.z});
  }
  return {std::move(profile), std::move(report), fitted};
}
}  // namespace wheel_rail_contact::core
