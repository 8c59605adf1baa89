// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/profile_points.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t least_points = 4;
constexpr double longest_polygon = 10.0;  ///< [m]; limits the memory of a spline

[[noreturn]] void refuse(const std::string& reason)
{
  throw std::invalid_argument("profile spline: " + reason);
}

void checkPoint(const SampledPoint& point, std::size_t i)
{
  if (!std::isfinite(point.y) || !std::isfinite(point.z))
  {
    refuse("point " + std::to_string(i) + " is not finite");
  }
  if (!(point.weight > 0.0) || !std::isfinite(point.weight))
  {
    refuse("weight of point " + std::to_string(i) + " is " + std::to_string(point.weight) + ", must be positive");
  }
}
}  // namespace

std::vector<double> polygonLength(const std::vector<SampledPoint>& points)
{
  if (points.size() < least_points)
  {
    refuse("number of points is " + std::to_string(points.size()) + ", must be at least " +
           std::to_string(least_points));
  }
  std::vector<double> length(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    checkPoint(points[i], i);
    if (i > 0)
    {
      length[i] = length[i - 1] + std::hypot(points[i].y - points[i - 1].y, points[i].z - points[i - 1].z);
      if (!(length[i] > length[i - 1]))
      {
        refuse("points " + std::to_string(i - 1) + " and " + std::to_string(i) + " are equal");
      }
    }
  }
  if (!(length.back() <= longest_polygon))
  {
    refuse("polygon through the points is " + std::to_string(length.back()) + " m long, must be at most " +
           std::to_string(longest_polygon) + " m");
  }
  return length;
}
}  // namespace wheel_rail_contact::core
