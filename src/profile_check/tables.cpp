// SPDX-License-Identifier: BSD-3-Clause
#include "profile_check/tables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "core/profile/curve_search.h"
#include "core/profile/profile_measures.h"
#include "profile_check/text.h"
#include "tables/csv.h"

namespace wheel_rail_contact::core::profile_check
{
namespace
{
constexpr double spacing = 1e-4;  ///< of the points of a drawn curve [m]

/// Parameters of a profile about `spacing` apart, with the middle of each section.
std::vector<double> parametersOf(const Profile& profile)
{
  const std::vector<double>& boundaries = profile.discontinuities();
  std::vector<double> parameters;
  for (std::size_t i = 0; i + 1 < boundaries.size(); ++i)
  {
    const double length = boundaries[i + 1] - boundaries[i];
    const int count = std::max(1, static_cast<int>(std::round(length / spacing)));
    for (int part = 0; part < count; ++part)
    {
      parameters.push_back(boundaries[i] + length * (part + 0.5) / count);
    }
  }
  return parameters;
}

/// Arc length as a function of the parameter of a curve [m].
class ArcLength
{
 public:
  explicit ArcLength(const Profile& profile) : parameters_(parametersOf(profile))
  {
    CurvePoint before = profile.at(0);
    double u_before = 0, length = 0;
    for (const double u : parameters_)
    {
      const CurvePoint p = profile.at(u);
      length += std::hypot(p.y - before.y, p.z - before.z);
      lengths_.push_back(length);
      before = p;
      u_before = u;
    }
    parameters_.push_back(std::max(profile.length(), std::nextafter(u_before, 1e9)));
    const CurvePoint last = profile.at(profile.length());
    lengths_.push_back(length + std::hypot(last.y - before.y, last.z - before.z));
  }
  double at(double u) const
  {
    const auto after = std::upper_bound(parameters_.begin(), parameters_.end(), u);
    if (after == parameters_.begin())
    {
      return lengths_.front() * u / parameters_.front();
    }
    if (after == parameters_.end())
    {
      return lengths_.back();
    }
    const auto i = static_cast<std::size_t>(after - parameters_.begin());
    const double share = (u - parameters_[i - 1]) / (parameters_[i] - parameters_[i - 1]);
    return lengths_[i - 1] + share * (lengths_[i] - lengths_[i - 1]);
  }

 private:
  std::vector<double> parameters_, lengths_;
};

void writeCurve(const Profile& profile, const ArcLength& arc, const std::filesystem::path& file)
{
  Csv csv(file);
  csv.line("arc_length,y,z,curvature,position_error,curvature_error,missing");
  for (const double u : parametersOf(profile))
  {
    const CurvePoint p = profile.at(u);
    const ShapeError& error = profile.errorAt(u);
    csv.row(arc.at(u), p.y, p.z, p.curvature(), error.position, error.curvature, error.missing ? 1 : 0);
  }
}

void writePoints(const DescribedProfile& described, const ArcLength& arc, const std::filesystem::path& file)
{
  const CurveFeet feet(described.profile);
  Csv csv(file);
  csv.line("arc_length,y,z,residual");
  for (const FittedPoint& point : described.points)
  {
    const double u = feet.nearest(point.y, point.z);
    csv.row(arc.at(u), point.y, point.z, distanceAcross(described.profile.at(u), point.y, point.z));
  }
}

void writeStandard(const CheckedProfile& checked, const std::filesystem::path& file)
{
  Csv csv(file);
  csv.line("y,z");
  if (!std::isfinite(checked.nearest.rms))
  {
    return;
  }
  const Profile standard = loadProfile(checked.nearest.name, checked.kind);
  const ProfileMotion& motion = checked.nearest.motion;
  const double c = std::cos(motion.rotation), s = std::sin(motion.rotation);
  for (const double u : parametersOf(standard))
  {
    const CurvePoint p = standard.at(u);
    csv.row(c * p.y - s * p.z + motion.y, s * p.y + c * p.z + motion.z);
  }
}

void writeMarks(const CheckedProfile& checked, const std::filesystem::path& file)
{
  Csv csv(file);
  csv.line("name,y,z");
  const auto write = [&csv](const char* name, const std::optional<ProfilePlace>& place)
  {
    if (place)
    {
      csv.row(name, place->y, place->z);
    }
  };
  if (checked.kind == ProfileKind::wheel)
  {
    const WheelMeasures wheel = wheelMeasures(checked.described.profile);
    write("running_circle", wheel.running_circle);
    write("flange_tip", wheel.flange_tip);
    write("front", wheel.front);
    write("flange_back", wheel.flange_back);
    write("upper", wheel.upper);
    return;
  }
  const RailMeasures rail = railMeasures(checked.described.profile);
  write("top", rail.top);
  write("gauge_point", rail.gauge_point);
  write("gauge_side", rail.gauge_side);
  write("field_side", rail.field_side);
}

/// Text in quotes, as a cell of a CSV file.
std::string quoted(const std::string& text)
{
  std::string cell = "\"";
  for (const char c : text)
  {
    cell += c == '"' ? "\"\"" : std::string(1, c);
  }
  return cell + '"';
}

void writeValues(const CheckedProfile& checked, const std::filesystem::path& file)
{
  Csv csv(file);
  csv.line("name,value");
  csv.row("kind", checked.kind == ProfileKind::wheel ? "wheel" : "rail");
  csv.row("report", quoted(checked.described.report.text));
  csv.row("smoothing", checked.described.report.smoothing);
  csv.row("standard", quoted(checked.nearest.name));
  csv.row("nearest", quoted(textOf(checked.nearest)));
}
}  // namespace

void writeTables(const CheckedProfile& checked, const std::filesystem::path& folder)
{
  const ArcLength arc(checked.described.profile);
  writeCurve(checked.described.profile, arc, folder / "curve.csv");
  writePoints(checked.described, arc, folder / "points.csv");
  writeStandard(checked, folder / "standard.csv");
  writeMarks(checked, folder / "marks.csv");
  writeValues(checked, folder / "values.csv");
}
}  // namespace wheel_rail_contact::core::profile_check
