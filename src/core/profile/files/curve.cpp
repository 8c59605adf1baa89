// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/profile/files/steps.h"
#include "core/profile/noise/noise.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Noise below which points are not smoothed [m]. The curvature is then known well enough.
constexpr double least_noise = 5e-8;

/// Noise of the points: as estimated, but not less than their rounding. Nothing if it is not known.
std::optional<NoiseEstimate> noiseOf(const FileProfile& content, double unit, const std::vector<SampledPoint>& points)
{
  const std::optional<NoiseEstimate> estimate = estimatedNoise(points);
  // Standard deviation of a uniform distribution.
  const double rounding =
      unit * content.magnification * std::pow(10.0, -content.decimals.value_or(0)) / std::sqrt(12.0);
  if (!estimate && rounding < least_noise)
  {
    return std::nullopt;
  }
  const NoiseEstimate known = estimate.value_or(NoiseEstimate{0, 0});
  return NoiseEstimate{std::max(known.typical, rounding), std::max(known.largest, rounding)};
}

/// Noise for which points are smoothed [m].
double smoothingOf(const TextFile& file, const FileProfile& content, const ProfileReading& reading, double noise)
{
  if (reading.smoothing)
  {
    return *reading.smoothing;
  }
  if (content.smoothing)
  {
    file.refuseIf(*content.smoothing > max_spline_noise, 0,
                  "approx.smooth is above " + millimetres(max_spline_noise) + "; the option smoothing overrides it");
    return *content.smoothing;
  }
  file.refuseIf(noise > max_spline_noise, 0,
                "noise or rounding of the points is " + millimetres(noise) + ", must be at most " +
                    millimetres(max_spline_noise) + "; the option smoothing overrides it: 0 if the points are exact");
  return noise < least_noise ? 0 : noise;
}

void addRemark(std::string& remarks, const std::string& remark)
{
  remarks += (remarks.empty() || remark.empty() ? "" : ", ") + remark;
}

/// Curve of a profile, and the points that determine its parameter.
struct Curve
{
  std::vector<ProfileSection> sections;
  std::vector<SampledPoint> points;
};

Curve interpolated(const std::vector<SampledPoint>& points, double noise)
{
  Curve curve{interpolatingSpline(points), points};
  addInterpolationError(noise, curve.sections);
  return curve;
}

/// Curve of the points. If an estimated noise is not that of a smooth curve, the curve passes through all points.
/// @param noise  typical noise of the points [m]
/// @param stated  the smoothing is that of the file or of an option
/// @throw FileError if a stated smoothing is not that of a smooth curve.
Curve curveOf(const TextFile& file, const std::vector<SampledPoint>& points, double noise, bool stated,
              ProfileReport& report)
{
  if (report.smoothing == 0)
  {
    return interpolated(points, noise);
  }
  try
  {
    Curve curve{{}, groupedPoints(points)};
    const double share = static_cast<double>(curve.points.size()) / static_cast<double>(points.size());
    curve.sections = smoothingSpline(curve.points, report.smoothing * std::sqrt(share));
    return curve;
  }
  catch (const std::invalid_argument& error)
  {
    file.refuseIf(stated, 0, std::string(error.what()) + "; give another smoothing, 0 for none");
    report.smoothing = 0;
    addRemark(report.remark, "a smoothed curve would leave the points");
    return interpolated(points, noise);
  }
}

/// Omits points that lie off the curve. @return a remark on them, empty if there are none
std::string withoutOutliers(const TextFile& file, double noise, std::vector<SampledPoint>& points)
{
  constexpr std::size_t least_limit = 3;
  constexpr double most_share = 0.02;  // of all points
  const auto most = std::max(least_limit, static_cast<std::size_t>(most_share * static_cast<double>(points.size())));
  const Outliers outliers = omitOutliers(noise, most, points);
  if (outliers.count == 0)
  {
    return "";
  }
  const std::string text = std::to_string(outliers.count) + " off the curve of the neighbours, by up to " +
                           millimetres(outliers.largest) + " (line " + std::to_string(outliers.line) + ")";
  file.refuseIf(outliers.count > most, outliers.line, "points: at least " + text + ": not a smooth curve");
  return "omitted points: " + text;
}
}  // namespace

std::vector<ProfileSection> curveThrough(const TextFile& file, const FileProfile& content, double unit,
                                         const ProfileReading& reading, std::vector<SampledPoint>& points,
                                         ProfileReport& report)
{
  const auto first_noise = noiseOf(content, unit, points);
  addRemark(report.remark, withoutOutliers(file, first_noise ? first_noise->largest : 0, points));
  const auto noise = noiseOf(content, unit, points);
  report.noise = noise ? std::optional(noise->largest) : std::nullopt;
  report.smoothing = smoothingOf(file, content, reading, report.noise.value_or(0));
  const bool stated = reading.smoothing || content.smoothing;
  Curve curve = curveOf(file, points, noise ? noise->typical : 0, stated, report);
  markMissing(curve.points, reading.smoothing == 0.0, curve.sections);
  return curve.sections;
}
}  // namespace wheel_rail_contact::core
