// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/profile/profile_file.h"

namespace wheel_rail_contact::core
{
namespace
{
using FilePoints = std::vector<FilePoint>;

// Bounds of a plausible profile [m].
constexpr std::size_t least_points = 10;
constexpr double least_width = 0.020;
constexpr double most_width = 0.300;
constexpr double most_height = 0.120;
constexpr double widest_gap = 0.025;
/// Least distance of neighbouring points [m]. Closer points do not determine a curvature: the rounding in files is 1e-6
/// to 1e-4 mm.
constexpr double least_distance = 5e-5;
/// Largest distance of the curve from the origin at y = 0 [m]. Wear is less.
constexpr double origin_tolerance = 0.005;
/// Least height difference between the field side and the flange tip [m].
constexpr double least_flange_height = 0.010;
/// Largest share of the points that may be omitted because the measurement runs back there.
constexpr double most_left_out = 0.05;

double distance(const FilePoint& a, const FilePoint& b)
{
  return std::hypot(b.point.y - a.point.y, b.point.z - a.point.z);
}

std::string millimetres(double length)
{
  std::ostringstream text;
  text << std::setprecision(4) << length * 1e3 << " mm";
  return text.str();
}

struct Box
{
  explicit Box(const FilePoints& points)
  {
    const auto [left, right] = std::minmax_element(points.begin(), points.end(),
                                                   [](const auto& a, const auto& b) { return a.point.y < b.point.y; });
    const auto [bottom, top] = std::minmax_element(points.begin(), points.end(),
                                                   [](const auto& a, const auto& b) { return a.point.z < b.point.z; });
    y_min = left->point.y;
    y_max = right->point.y;
    lowest = bottom->point;
    highest = top->point;
  }
  double width() const { return y_max - y_min; }
  /// Relative position across the profile: 0 at its smallest y, 1 at its largest y.
  double share(double y) const { return (y - y_min) / width(); }

  double y_min, y_max;
  SampledPoint lowest, highest;
};

void checkSize(const ProfileFile& file, const FilePoints& points)
{
  if (points.size() < least_points)
  {
    file.refuse(0, "number of points is " + std::to_string(points.size()) + ", must be at least " +
                       std::to_string(least_points));
  }
  for (const FilePoint& p : points)
  {
    if (!std::isfinite(p.point.y) || !std::isfinite(p.point.z))
    {
      file.refuse(p.line, "coordinate of the point is too large");
    }
  }
  const Box box(points);
  const double height = box.highest.z - box.lowest.z;
  if (!(box.width() >= least_width && box.width() <= most_width))
  {
    file.refuse(0, "profile is " + millimetres(box.width()) + " wide, must be " + millimetres(least_width) + " to " +
                       millimetres(most_width) + ": wrong unit or not a profile");
  }
  if (!(height <= most_height))
  {
    file.refuse(0, "profile is " + millimetres(height) + " high, must be at most " + millimetres(most_height) +
                       ": wrong unit or not a profile");
  }
}

/// Points without those too close to the preceding kept one. The last point is always kept: it replaces the last kept
/// one.
FilePoints withoutNearPoints(const FilePoints& points)
{
  FilePoints kept{points.front()};
  for (const FilePoint& p : points)
  {
    if (distance(kept.back(), p) >= least_distance)
    {
      kept.push_back(p);
    }
  }
  if (kept.size() > 1)
  {
    kept.back() = points.back();
  }
  return kept;
}

/// Points without those at which the measurement runs back by up to the overlap.
/// @throw ProfileError if it runs back further, too often, or has a gap.
FilePoints alongTheCurve(const ProfileFile& file, const FilePoints& points, double overlap)
{
  FilePoints kept;
  for (const FilePoint& p : points)
  {
    if (kept.empty())
    {
      kept.push_back(p);
      continue;
    }
    const FilePoint& last = kept.back();
    const double step = distance(last, p);
    if (step < least_distance)
    {
      continue;
    }
    bool back = false;
    if (kept.size() > 1)
    {
      const SampledPoint& a = kept[kept.size() - 2].point;
      const SampledPoint& b = last.point;
      back = (b.y - a.y) * (p.point.y - b.y) + (b.z - a.z) * (p.point.z - b.z) < 0.0;
    }
    if (back && step > overlap)
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
  if (static_cast<double>(points.size() - kept.size()) > most_left_out * static_cast<double>(points.size()))
  {
    file.refuse(0, std::to_string(points.size() - kept.size()) + " of " + std::to_string(points.size()) +
                       " points run back: not in order along the profile");
  }
  return kept;
}

void checkExtent(const ProfileFile& file, const FilePoints& points)
{
  const double width = Box(points).width();
  const double between_ends = points.back().point.y - points.front().point.y;
  if (between_ends < 0.7 * width)
  {
    file.refuse(0, "ends are " + millimetres(between_ends) + " apart, profile is " + millimetres(width) +
                       " wide: a closed outline or not a profile");
  }
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += distance(points[i - 1], points[i]);
  }
  if (length > 3.0 * width)
  {
    file.refuse(0, "curve is " + millimetres(length) + " long, profile is " + millimetres(width) +
                       " wide: points not in order along the profile or not a profile");
  }
}

void checkOrigin(const ProfileFile& file, const FilePoints& points)
{
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const SampledPoint& a = points[i - 1].point;
    const SampledPoint& b = points[i].point;
    if (a.y <= 0.0 && b.y > 0.0 && std::abs(a.z + (b.z - a.z) * (-a.y) / (b.y - a.y)) <= origin_tolerance)
    {
      return;
    }
  }
  file.refuse(0, "profile does not pass within " + millimetres(origin_tolerance) +
                     " of its origin, which must be the running circle of a wheel or the crown of a rail");
}

void checkRail(const ProfileFile& file, const FilePoints& points)
{
  const Box box(points);
  const double top = box.share(box.highest.y);
  if (!(top > 0.05 && top < 0.95))
  {
    file.refuse(0, "highest point is at an end: not a rail, or z does not point up");
  }
  const double bottom = box.share(box.lowest.y);
  if (bottom > 0.08 && bottom < 0.92)
  {
    file.refuse(0, "lowest point is not at an end: not a rail");
  }
}

/// A section of a rail turned upside down is a bowl.
void checkSection(const ProfileFile& file, const FilePoints& points)
{
  const Box box(points);
  const auto is_end = [&](const SampledPoint& point)
  { return point.z == points.front().point.z || point.z == points.back().point.z; };
  if (is_end(box.highest) && !is_end(box.lowest))
  {
    file.refuse(0, "highest point is at an end, lowest point is not: z does not point as the format requires");
  }
}

void checkWheel(const ProfileFile& file, const FilePoints& points)
{
  const Box box(points);
  if (box.share(box.lowest.y) > 0.6)
  {
    file.refuse(0,
                "lowest point is on the field side: not a wheel with its flange on the gauge side, or an axis is "
                "reversed");
  }
  if (points.back().point.z - box.lowest.z < least_flange_height || box.share(box.lowest.y) > 0.4)
  {
    file.refuse(0, "no flange of at least " + millimetres(least_flange_height) + " on the gauge side: not a wheel");
  }
}

/// Detects a wheel profile that is rotated by 180 degrees: its tread is as before, but its flange points up, on the
/// field side.
void checkFlangeReachesDown(const ProfileFile& file, const FilePoints& points)
{
  if (Box(points).lowest.z > -least_flange_height)
  {
    file.refuse(0, "no flange reaches " + millimetres(least_flange_height) +
                       " below the running circle: not a wheel, or both axes are reversed");
  }
}
}  // namespace

std::vector<SampledPoint> orderedPoints(const ProfileFile& file, const FileProfile& content, ProfileKind kind)
{
  checkSize(file, content.points);
  FilePoints points = alongTheCurve(file, withoutNearPoints(content.points), content.overlap);
  if (points.back().point.y < points.front().point.y)
  {
    std::reverse(points.begin(), points.end());
  }
  checkSize(file, points);
  checkExtent(file, points);
  if (kind == ProfileKind::rail_section)
  {
    checkSection(file, points);
  }
  else
  {
    (kind == ProfileKind::rail ? checkRail : checkWheel)(file, points);
    checkOrigin(file, points);
  }
  if (kind == ProfileKind::wheel)
  {
    checkFlangeReachesDown(file, points);
  }
  std::vector<SampledPoint> ordered;
  for (const FilePoint& p : points)
  {
    ordered.push_back(p.point);
  }
  return ordered;
}
}  // namespace wheel_rail_contact::core
