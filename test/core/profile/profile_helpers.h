// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iomanip>

#include "../../last_where.h"
#include "../../refusal.h"
#include "../../temporary_folder.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
constexpr double mm = 1e-3;  ///< [m]

/// Parameter at which a curve with increasing y reaches `y` [m].
inline double parameterAt(const Profile& profile, double y)
{
  return lastWhere([&](double u) { return profile.at(u).y < y; }, 0, profile.length());
}

/// Options of a file whose y is to be reversed.
inline ProfileReading mirrored(std::optional<double> smoothing = std::nullopt)
{
  ProfileReading reading;
  reading.smoothing = smoothing;
  reading.mirror = true;
  return reading;
}

/// Two coordinates, in the unit and axes of a file.
struct Point
{
  double y, z;
};

/// Points of a profile about 0.25 mm apart, in the profile frame [m].
inline std::vector<Point> pointsOf(const Profile& profile)
{
  const int count = static_cast<int>(profile.length() / (0.25 * mm));
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i)
  {
    const CurvePoint p = profile.at(profile.length() * i / count);
    points.push_back({p.y, p.z});
  }
  return points;
}

/// Points after a change of axes or units.
inline std::vector<Point> changed(const std::vector<Point>& points, const std::function<Point(const Point&)>& change)
{
  std::vector<Point> result;
  std::transform(points.begin(), points.end(), std::back_inserter(result), change);
  return result;
}

inline std::vector<Point> moved(const std::vector<Point>& points, double y, double z)
{
  return changed(points, [=](const Point& p) { return Point{p.y + y, p.z + z}; });
}

/// Points with other units or directions of the axes.
inline std::vector<Point> scaled(const std::vector<Point>& points, double y, double z)
{
  return changed(points, [=](const Point& p) { return Point{p.y * y, p.z * z}; });
}

/// One line per point, the coordinates separated by `separator`.
inline std::string lines(const std::vector<Point>& points, const std::string& separator)
{
  std::ostringstream text;
  text << std::setprecision(12);
  for (const Point& p : points)
  {
    text << p.y << separator << p.z << "\n";
  }
  return text.str();
}

/// Table of points [m].
inline std::string csv(const std::vector<Point>& points)
{
  return "y_m,z_m\n" + lines(points, ",");
}

/// Largest distance of points from a profile close to them, across the curve [m]. The points must be in order along it.
inline double deviation(const Profile& profile, const std::vector<Point>& points)
{
  double largest = 0.0;
  double u = 0.0;
  for (const Point& point : points)
  {
    for (double candidate = u; candidate < std::min(u + 5 * mm, profile.length()); candidate += 0.1 * mm)
    {
      const CurvePoint p = profile.at(candidate);
      const CurvePoint q = profile.at(u);
      u = std::hypot(p.y - point.y, p.z - point.z) < std::hypot(q.y - point.y, q.z - point.z) ? candidate : u;
    }
    for (int step = 0; step < 20; ++step)
    {
      const CurvePoint p = profile.at(u);
      u -= ((p.y - point.y) * p.dy + (p.z - point.z) * p.dz) / (p.dy * p.dy + p.dz * p.dz);
      u = std::clamp(u, 0.0, profile.length());
    }
    const CurvePoint p = profile.at(u);
    largest = std::max(largest, std::hypot(p.y - point.y, p.z - point.z));
  }
  return largest;
}
}  // namespace wheel_rail_contact::core
