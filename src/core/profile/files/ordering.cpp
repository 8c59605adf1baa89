// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/profile/files/steps.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
namespace
{
using Points = std::vector<SampledPoint>;

constexpr double widest_gap = 0.025;  ///< [m]
/// Least distance of neighbouring points [m]. Closer points do not determine a curvature: the rounding in files is 1e-6
/// to 1e-4 mm.
constexpr double least_distance = 5e-5;
/// Largest distance over which a measurement in two strokes may run back [m].
constexpr double largest_overlap = 1e-3;
/// Largest share of the points that may be omitted because the measurement runs back there.
constexpr double most_left_out = 0.05;

/// Points without those too close to the preceding kept one. The last point is always kept: it replaces the last kept
/// one.
Points withoutNearPoints(const Points& points)
{
  Points kept = thinnedOut(points, least_distance);
  if (kept.size() > 1)
  {
    kept.back() = points.back();
  }
  return kept;
}

/// True if a point lies behind the last one of a curve.
bool runsBack(const Points& curve, const SampledPoint& next)
{
  if (curve.size() < 2)
  {
    return false;
  }
  const SampledPoint &a = curve[curve.size() - 2], &b = curve.back(), &c = next;
  return (b.y - a.y) * (c.y - b.y) + (b.z - a.z) * (c.z - b.z) < 0.0;
}

/// Points without those at which the measurement runs back by up to the overlap.
/// @throw FileError if it runs back further, too often, or has a gap.
Points alongTheCurve(const TextFile& file, const Points& points)
{
  Points kept{points.front()};
  for (const SampledPoint& p : points)
  {
    const double step = distance(kept.back(), p);
    if (step < least_distance)
    {
      continue;
    }
    const bool back = runsBack(kept, p);
    if (back && step > largest_overlap)
    {
      file.refuse(p.line, "points run back by " + millimetres(step) + ": not in order along the profile");
    }
    if (step > widest_gap)
    {
      file.refuse(p.line,
                  "gap of " + millimetres(step) + " in the profile, must be at most " + millimetres(widest_gap));
    }
    if (!back)
    {
      kept.push_back(p);
    }
  }
  file.refuseIf(static_cast<double>(points.size() - kept.size()) > most_left_out * static_cast<double>(points.size()),
                0,
                std::to_string(points.size() - kept.size()) + " of " + std::to_string(points.size()) +
                    " points run back: not in order along the profile");
  return kept;
}
}  // namespace

std::string averageCloud(ProfileKind kind, std::vector<SampledPoint>& points)
{
  constexpr std::size_t least_cloud = 20000;
  constexpr double group = 1e-4;  // of the means along the curve [m]
  if (points.size() <= least_cloud)
  {
    return "";
  }
  // A place from which the whole curve is seen: inside of the head of a rail; in the wheel, above the flange.
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), isFartherInward);
  const double top = std::max_element(points.begin(), points.end(), isLower)->z;
  const bool is_wheel = kind == ProfileKind::wheel;
  const double y = is_wheel ? left->y + 0.025 : 0.5 * (left->y + right->y);
  const double z = is_wheel ? top + 0.060 : top - 0.025, sign = is_wheel ? -1 : 1;
  const auto angle = [=](const SampledPoint& p) { return std::atan2(p.y - y, sign * (p.z - z)); };
  std::sort(points.begin(), points.end(),
            [&](const SampledPoint& a, const SampledPoint& b) { return angle(a) < angle(b); });
  Points means;
  for (std::size_t i = 0; i < points.size();)
  {
    SampledPoint mean{0, 0, 1, points[i].line};
    const double begin = angle(points[i]), radius = std::hypot(points[i].y - y, points[i].z - z);
    std::size_t count = 0;
    for (; i < points.size() && (angle(points[i]) - begin) * radius < group; ++i)
    {
      mean.y += points[i].y;
      mean.z += points[i].z;
      ++count;
    }
    mean.y /= static_cast<double>(count);
    mean.z /= static_cast<double>(count);
    means.push_back(mean);
  }
  std::string text = std::to_string(points.size()) + " points, in any order, averaged over 0.1 mm";
  points = means;
  return text;
}

std::vector<SampledPoint> orderedPoints(const TextFile& file, const std::vector<SampledPoint>& points, ProfileKind kind)
{
  checkSize(file, points);
  Points curve = alongTheCurve(file, withoutNearPoints(points));
  if (curve.back().y < curve.front().y)
  {
    std::reverse(curve.begin(), curve.end());
  }
  checkSize(file, curve);
  checkShape(file, curve, kind);
  return curve;
}
}  // namespace wheel_rail_contact::core
