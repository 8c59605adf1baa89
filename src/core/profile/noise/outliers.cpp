// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/profile/noise/curve_windows.h"
#include "core/profile/noise/noise.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_ratio = 10;       ///< of the distance from the curve and the noise
constexpr double least_distance = 5e-6;  ///< [m]
constexpr double sharpest = 100;         ///< curvature that a profile may have on one side of a point only [1/m]
constexpr double largest_turn = 0.3;     ///< of the curve around a group [rad]; at a kink it is larger
constexpr double smooth_share = 0.25;    ///< largest share of that distance in the residuals of the neighbours
constexpr std::size_t longest_group = 3;
constexpr double larger_group = 1.5;  ///< least ratio of the distances by which a larger group is preferred

/// True if the curve is smooth at the neighbours of a group when the group is left out.
bool isSmoothWithout(const CurveWindows& windows, std::size_t first, std::size_t last, std::size_t size, double most)
{
  const auto is_smooth = [&](std::size_t point)
  {
    const auto residual = windows.residualWithout(point, first, last);
    return !residual || std::abs(residual->across) <= most;
  };
  return (first == 0 || is_smooth(first - 1)) && (last + 1 >= size || is_smooth(last + 1));
}

/// Distance of a group from the curve of its neighbours if it is an outlier; 0 if it is none [m].
double distanceOf(const CurveWindows& windows, std::size_t first, std::size_t last, std::size_t size, double noise)
{
  const auto residual = windows.residual(first, last);
  if (!residual)
  {
    return 0;
  }
  const double distance = std::abs(residual->across);
  // A cubic over a length is off by a 16th of its square times the change of curvature.
  const double least = std::max(
      {least_distance, least_ratio * noise * residual->deviation, sharpest * residual->length * residual->length / 16});
  return residual->turn < largest_turn && std::abs(residual->at_first) > least &&
                 isSmoothWithout(windows, first, last, size, smooth_share * distance)
             ? distance
             : 0;
}

struct Group
{
  std::size_t first = 0, size = 0;
  double distance = 0;  ///< from the curve of the neighbours [m]; 0: there is none
};

/// The group that is farthest from the curve of its neighbours. Others may seem to be off because of it.
Group farthestGroup(const std::vector<SampledPoint>& points, double noise)
{
  const CurveWindows windows(points);
  Group farthest;
  for (std::size_t size = 1; size <= longest_group; ++size)
  {
    for (std::size_t i = 0; i + size <= points.size(); ++i)
    {
      const double distance = distanceOf(windows, i, i + size - 1, points.size(), noise);
      if (distance > farthest.distance * (size > farthest.size ? larger_group : 1))
      {
        farthest = {i, size, distance};
      }
    }
  }
  return farthest;
}
}  // namespace

Outliers omitOutliers(double noise, std::size_t most, std::vector<SampledPoint>& points)
{
  Outliers found;
  while (found.count <= most)
  {
    const Group group = farthestGroup(points, noise);
    if (group.distance == 0)
    {
      return found;
    }
    found.line = group.distance > found.largest ? points[group.first].line : found.line;
    found.largest = std::max(found.largest, group.distance);
    found.count += group.size;
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(group.first);
    points.erase(first, first + static_cast<std::ptrdiff_t>(group.size));
  }
  return found;
}
}  // namespace wheel_rail_contact::core
