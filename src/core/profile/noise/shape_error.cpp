// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/profile/noise/noise.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_gap = 2e-3;  ///< shortest distance at which points can be missing [m]
constexpr double gap_factor = 5;    ///< least ratio of such a distance to the median distance
constexpr double sure_gap =
    4e-3;  ///< distance over which points are always missing: arcs of profiles are 10 mm long [m]
constexpr double straight = 1e-3;  ///< angle below which three points are on a line [rad]

/// Angle between two neighbouring segments of a polygon [rad].
double turnAt(const std::vector<SampledPoint>& points, std::size_t i)
{
  const SampledPoint &a = points[i - 1], &b = points[i], &c = points[i + 1];
  const double y1 = b.y - a.y, z1 = b.z - a.z, y2 = c.y - b.y, z2 = c.z - b.z;
  return std::abs(std::atan2(y1 * z2 - z1 * y2, y1 * y2 + z1 * z2));
}

bool isSteep(const std::vector<SampledPoint>& points, std::size_t i)
{
  return std::abs(points[i + 1].z - points[i].z) > std::abs(points[i + 1].y - points[i].y);
}

/// True if the curve between points i and i + 1 continues straight lines before and after it.
bool isStraight(const std::vector<SampledPoint>& points, std::size_t i)
{
  const bool before = i == 0 || turnAt(points, i) < straight;
  const bool after = i + 2 == points.size() || turnAt(points, i + 1) < straight;
  return before && after;
}
}  // namespace

void addInterpolationError(double noise, std::vector<ProfileSection>& sections)
{
  for (ProfileSection& section : sections)
  {
    section.error.position = noise;
    section.error.curvature = 6 * noise / (section.length * section.length);
  }
}

void markMissing(const std::vector<SampledPoint>& points, bool exact, std::vector<ProfileSection>& sections)
{
  const std::vector<double> length = polygonLength(points);
  std::vector<double> distance;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    distance.push_back(length[i + 1] - length[i]);
  }
  std::vector<double> sorted = distance;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double least = std::min(sure_gap, std::max(least_gap, gap_factor * sorted[sorted.size() / 2]));
  double begin = 0;
  std::size_t i = 0;
  for (ProfileSection& section : sections)
  {
    const double middle = begin + 0.5 * section.length;
    begin += section.length;
    while (i + 2 < points.size() && length[i + 1] < middle)
    {
      ++i;
    }
    const bool is_line = (exact || isSteep(points, i)) && isStraight(points, i);
    section.error.missing = distance[i] > least && !is_line;
  }
}
}  // namespace wheel_rail_contact::core
