// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/curve_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/profile/curve_search.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_spacing = 0.06e-3;  ///< points closer than 0.05 mm are omitted by readProfile() [m]
constexpr double most_turn = 0.1;          ///< of the tangent from point to point [rad]
constexpr double reach = 1e-3;             ///< around ends and discontinuities, over which the points are closest [m]
constexpr double least_change = 1;         ///< of the curvature, that counts as a discontinuity [1/m]
constexpr double beside = 1e-9;            ///< a section boundary [m]

/// Parameters around which points are closest: ends, discontinuities of the curvature and ends of missing ranges.
std::vector<double> sharpPlaces(const Profile& profile)
{
  const std::vector<double>& boundaries = profile.discontinuities();
  std::vector<double> sharp{boundaries.front()};
  for (std::size_t i = 1; i + 1 < boundaries.size(); ++i)
  {
    const double before = boundaries[i] - beside, after = boundaries[i] + beside;
    const double change = std::abs(profile.at(after).curvature() - profile.at(before).curvature());
    if (change > least_change || profile.errorAt(before).missing != profile.errorAt(after).missing)
    {
      sharp.push_back(boundaries[i]);
    }
  }
  sharp.push_back(boundaries.back());
  return sharp;
}

/// Where points are closest, and their distance elsewhere [m].
struct Spacing
{
  std::vector<double> sharp;
  double most;
};

/// Distance of the points at a parameter [m].
double spacingAt(const Profile& profile, const Spacing& spacing, double u)
{
  const std::vector<double>& sharp = spacing.sharp;
  const auto next = std::lower_bound(sharp.begin(), sharp.end(), u);
  const bool is_near = (next != sharp.end() && *next - u < reach) || (next != sharp.begin() && u - *(next - 1) < reach);
  const double by_turn = most_turn / std::max(std::abs(profile.at(u).curvature()), most_turn / spacing.most);
  return is_near ? least_spacing : std::max(by_turn, least_spacing);
}

/// Appends the points of a section between its ends.
void addInside(const Profile& profile, const Spacing& spacing, const ParameterRange& section,
               std::vector<ProfilePlace>& points)
{
  for (double u = section.begin;;)
  {
    const CurvePoint here = profile.at(u);
    const double rest = (section.end - u) * std::hypot(here.dy, here.dz);
    const double most = std::floor(rest / least_spacing);
    const double count = std::min(std::ceil(rest / spacingAt(profile, spacing, u)), most);
    if (count <= 1)
    {
      return;
    }
    u += (section.end - u) / count;
    const CurvePoint p = profile.at(u);
    points.push_back({p.y, p.z});
  }
}
}  // namespace

std::vector<ProfilePlace> pointsAlong(const Profile& profile, double spacing)
{
  const std::vector<double>& boundaries = profile.discontinuities();
  const Spacing spacings{sharpPlaces(profile), spacing};
  std::vector<ProfilePlace> points;
  bool missing_before = false;
  for (std::size_t i = 0; i + 1 < boundaries.size(); ++i)
  {
    const bool missing = profile.errorAt(0.5 * (boundaries[i] + boundaries[i + 1])).missing;
    if (!missing || !missing_before)
    {
      const CurvePoint p = profile.at(boundaries[i]);
      points.push_back({p.y, p.z});
    }
    if (!missing)
    {
      addInside(profile, spacings, {boundaries[i], boundaries[i + 1]}, points);
    }
    missing_before = missing;
  }
  const CurvePoint last = profile.at(boundaries.back());
  points.push_back({last.y, last.z});
  return points;
}

double largestDistance(const Profile& profile, const Profile& other)
{
  const CurveFeet feet(other);
  const int count = static_cast<int>(std::ceil(profile.length() / least_spacing));
  double largest = 0;
  for (int i = 0; i <= count; ++i)
  {
    const double u = profile.length() * i / count;
    const CurvePoint p = profile.at(u);
    const double foot = feet.nearest(p.y, p.z);
    if (!profile.errorAt(u).missing && !other.errorAt(foot).missing)
    {
      const CurvePoint q = other.at(foot);
      largest = std::max(largest, std::hypot(p.y - q.y, p.z - q.z));
    }
  }
  return largest;
}
}  // namespace wheel_rail_contact::core
