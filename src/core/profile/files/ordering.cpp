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
/// Ends of the parts of a rail's outline that grooves divide [m]: y of each groove, and infinity.
/// @param points  from the gauge side
std::vector<double> grooveMiddles(const Points& points)
{
  constexpr double depth = 0.025, least_width = 0.005;  // [m]
  const double least = std::max_element(points.begin(), points.end(), isLower)->z - depth;
  std::vector<double> middles;
  double last = INFINITY;
  for (const SampledPoint& p : points)
  {
    if (p.z > least)
    {
      if (p.y - last > least_width)
      {
        middles.push_back(0.5 * (p.y + last));
      }
      last = p.y;
    }
  }
  middles.push_back(INFINITY);
  return middles;
}

/// Means of points over 0.1 mm of angle about a place from which the whole curve is seen, in this order.
/// @param sign  1: the place is below the curve, -1: above it
Points meansAround(const TextFile& file, double y, double z, double sign, Points points)
{
  constexpr double group = 1e-4, widest = 2e-3, most_wide = 0.02;  // along and across the curve [m]; share
  const auto angle = [=](const SampledPoint& p) { return std::atan2(p.y - y, sign * (p.z - z)); };
  std::sort(points.begin(), points.end(),
            [&](const SampledPoint& a, const SampledPoint& b) { return angle(a) < angle(b); });
  Points means;
  std::size_t wide = 0;
  for (std::size_t i = 0; i < points.size();)
  {
    SampledPoint mean{0, 0, 1, points[i].line};
    const double begin = angle(points[i]), radius = std::hypot(points[i].y - y, points[i].z - z);
    const std::size_t first = i;
    double nearest = radius, farthest = radius;
    for (; i < points.size() && (angle(points[i]) - begin) * radius < group; ++i)
    {
      mean.y += points[i].y;
      mean.z += points[i].z;
      nearest = std::min(nearest, std::hypot(points[i].y - y, points[i].z - z));
      farthest = std::max(farthest, std::hypot(points[i].y - y, points[i].z - z));
    }
    mean.y /= static_cast<double>(i - first);
    mean.z /= static_cast<double>(i - first);
    wide += farthest - nearest > widest ? 1U : 0U;
    means.push_back(mean);
  }
  file.refuseIf(static_cast<double>(wide) > most_wide * static_cast<double>(means.size()), 0,
                "more than 20000 points in any order are averaged, and these are not one curve: give them in order, or "
                "fewer of them");
  return means;
}
}  // namespace

std::string averageCloud(const TextFile& file, ProfileKind kind, std::vector<SampledPoint>& points)
{
  constexpr std::size_t least_cloud = 20000;
  if (points.size() <= least_cloud)
  {
    return "";
  }
  std::sort(points.begin(), points.end(), isFartherInward);
  const auto [bottom, top] = std::minmax_element(points.begin(), points.end(), isLower);
  Points means;
  if (kind == ProfileKind::wheel)
  {
    means = meansAround(file, points.front().y + 0.025, top->z + 0.060, -1, points);  // above the flange
  }
  else
  {
    const std::vector<double> grooves = grooveMiddles(points);
    // Inside of a head; below the floor of a groove, if there is one.
    const double z = grooves.size() > 1 ? bottom->z - 0.005 : top->z - 0.025;
    auto begin = points.begin();
    for (const double groove : grooves)
    {
      const auto end = std::find_if(begin, points.end(), [&](const SampledPoint& p) { return p.y > groove; });
      const Points part = meansAround(file, 0.5 * (begin->y + std::prev(end)->y), z, 1, Points(begin, end));
      means.insert(means.end(), part.begin(), part.end());
      begin = end;
    }
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
