// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/curve_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double scan_spacing = 1e-4;    ///< of the parameters at which a value is compared with zero [m]
constexpr int halvings = 60;             ///< of an interval, to rounding
constexpr double foot_spacing = 5e-4;    ///< of the points of which the nearest one is the start of a search [m]
constexpr int foot_steps = 20;           ///< most steps of Newton's method
constexpr double foot_accuracy = 1e-12;  ///< of the parameter of a nearest point [m]
constexpr double end_distance = 1e-9;    ///< from an end of the curve, within which a point is at this end [m]

/// Zero between two parameters at which a value has different signs.
double bisected(const std::function<double(double)>& value, double a, double b)
{
  const bool sign = value(a) > 0;
  for (int i = 0; i < halvings; ++i)
  {
    const double middle = 0.5 * (a + b);
    ((value(middle) > 0) == sign ? a : b) = middle;
  }
  return 0.5 * (a + b);
}

/// Number of equal intervals of a range that are at most `spacing` long.
int intervals(double length, double spacing)
{
  return std::max(1, static_cast<int>(std::ceil(std::abs(length) / spacing)));
}
}  // namespace

std::optional<double> firstZero(const Profile& profile, const PointValue& value, double from, double to)
{
  const auto at = [&](double u) { return value(profile.at(u)); };
  const int count = intervals(to - from, scan_spacing);
  const bool sign = at(from) > 0;
  double before = from;
  for (int i = 1; i <= count; ++i)
  {
    const double u = from + (to - from) * i / count;
    if ((at(u) > 0) != sign)
    {
      return bisected(at, before, u);
    }
    before = u;
  }
  return std::nullopt;
}

double whereLargest(const Profile& profile, const PointValue& value, const ParameterRange& range)
{
  const auto at = [&](double u) { return value(profile.at(u)); };
  const int count = intervals(range.end - range.begin, scan_spacing);
  const double step = (range.end - range.begin) / count;
  int largest = 0;
  for (int i = 1; i <= count; ++i)
  {
    largest = at(range.begin + i * step) > at(range.begin + largest * step) ? i : largest;
  }
  double a = range.begin + std::max(largest - 1, 0) * step;
  double b = range.begin + std::min(largest + 1, count) * step;
  for (int i = 0; i < halvings; ++i)
  {
    const double first = a + (b - a) / 3, second = b - (b - a) / 3;
    (at(first) < at(second) ? a : b) = at(first) < at(second) ? first : second;
  }
  return 0.5 * (a + b);
}

CurveFeet::CurveFeet(const Profile& profile) : profile_(&profile)
{
  const int count = intervals(profile.length(), foot_spacing);
  spacing_ = profile.length() / count;
  for (int i = 0; i <= count; ++i)
  {
    points_.push_back(profile.at(i * spacing_));
  }
}

double CurveFeet::nearest(double y, double z) const
{
  const auto squared = [&](const CurvePoint& p) { return (p.y - y) * (p.y - y) + (p.z - z) * (p.z - z); };
  const auto start =
      std::min_element(points_.begin(), points_.end(),
                       [&](const CurvePoint& a, const CurvePoint& b) { return squared(a) < squared(b); });
  double u = static_cast<double>(start - points_.begin()) * spacing_;
  for (int i = 0; i < foot_steps; ++i)
  {
    const CurvePoint p = profile_->at(u);
    const double along = (y - p.y) * p.dy + (z - p.z) * p.dz;
    const double speed = p.dy * p.dy + p.dz * p.dz;
    // Newton's derivative can vanish in the centre of curvature; the half of the speed is then a step that is safe.
    const double slope = std::max(speed - (y - p.y) * p.ddy - (z - p.z) * p.ddz, 0.5 * speed);
    const double next = std::clamp(u + along / slope, 0.0, profile_->length());
    if (std::abs(next - u) < foot_accuracy)
    {
      return next;
    }
    u = next;
  }
  return u;
}

bool CurveFeet::isEnd(double u) const
{
  return u < end_distance || u > profile_->length() - end_distance;
}

double distanceAcross(const CurvePoint& p, double y, double z)
{
  return (p.dy * (z - p.z) - p.dz * (y - p.y)) / std::hypot(p.dy, p.dz);
}
}  // namespace wheel_rail_contact::core
