// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/curve/measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double upper_distance = 0.002;  ///< of the upper point of qR from the flange tip [m]
/// Range of depths in which the sides of a head are straight: below the corners, also of an inclined rail [m].
constexpr double side_begin = 0.017, side_end = 0.026;
constexpr double least_side = 0.004;   ///< height of a side whose lean is determined [m]
constexpr double straightness = 5e-5;  ///< largest deviation from a line, root mean square [m]
constexpr int side_points = 100;
constexpr double scan_spacing = 1e-4;  ///< of the parameters at which a value is compared with zero [m]
constexpr int halvings = 50;           ///< of an interval, to rounding

/// Value of a point of a curve [m].
using PointValue = std::function<double(const CurvePoint&)>;

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

/// Number of equal intervals of a range of this length that are at most `scan_spacing` long.
int intervals(double length)
{
  return std::max(1, static_cast<int>(std::ceil(std::abs(length) / scan_spacing)));
}

/// First parameter u at which a value changes its sign, from the parameter `from` towards `to` [m]; nothing if it does
/// not. Two changes within 0.1 mm may be missed.
std::optional<double> firstZero(const Profile& profile, const PointValue& value, double from, double to)
{
  const auto at = [&](double u) { return value(profile.at(u)); };
  const int count = intervals(to - from);
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

/// Parameter u of the largest value in a range [m].
double whereLargest(const Profile& profile, const PointValue& value, const ParameterRange& range)
{
  const auto at = [&](double u) { return value(profile.at(u)); };
  const int count = intervals(range.end - range.begin);
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

ProfilePlace placeAt(const Profile& profile, double u)
{
  const CurvePoint p = profile.at(u);
  return {p.y, p.z};
}

std::optional<ProfilePlace> placeAt(const Profile& profile, std::optional<double> u)
{
  return u ? std::optional(placeAt(profile, *u)) : std::nullopt;
}

double whereTop(const Profile& profile)
{
  return whereLargest(profile, [](const CurvePoint& p) { return p.z; }, {0, profile.length()});
}

double whereTip(const Profile& profile)
{
  return whereLargest(profile, [](const CurvePoint& p) { return -p.z; }, {0, profile.length()});
}

/// Parameter at which the curve first has the height z, from `from` towards `to`.
std::optional<double> whereHeight(const Profile& profile, double z, double from, double to)
{
  return firstZero(
      profile, [z](const CurvePoint& p) { return p.z - z; }, from, to);
}

/// Straight line y(z) nearest to points: its slope dy/dz, and the root mean square deviation [m].
struct NearestLine
{
  double slope, deviation;
};

NearestLine nearestLine(const std::vector<ProfilePlace>& points)
{
  double y = 0, z = 0, yy = 0, yz = 0, zz = 0;
  for (const ProfilePlace& p : points)
  {
    const double share = 1.0 / static_cast<double>(points.size());
    y += share * p.y;
    z += share * p.z;
    yy += share * p.y * p.y;
    yz += share * p.y * p.z;
    zz += share * p.z * p.z;
  }
  const double slope = (yz - y * z) / (zz - z * z);
  return {slope, std::sqrt(std::max(0.0, yy - y * y - slope * (yz - y * z)))};
}

/// Lean of one side of a head, see RailMeasures.
std::optional<double> leanOfSide(const Profile& profile, double top, double end)
{
  const double z_top = profile.at(top).z;
  const std::optional<double> first = whereHeight(profile, z_top - side_begin, top, end);
  if (!first || !whereHeight(profile, z_top - side_begin - least_side, top, end))
  {
    return std::nullopt;
  }
  const double last = whereHeight(profile, z_top - side_end, top, end).value_or(end);
  if (profile.errorWithin(std::min(*first, last), std::max(*first, last)).missing)
  {
    return std::nullopt;
  }
  std::vector<ProfilePlace> side;
  for (int i = 0; i <= side_points; ++i)
  {
    side.push_back(placeAt(profile, *first + (last - *first) * i / side_points));
  }
  const NearestLine line = nearestLine(side);
  return line.deviation < straightness ? std::optional(std::atan(line.slope)) : std::nullopt;
}
/// The line nearest to the middles of a head, in axes that lean by an angle towards the track centre; nothing if a side
/// ends 8 mm below the top.
std::optional<NearestLine> middleLine(const Profile& profile, double angle)
{
  constexpr double first = 1e-3, most = 13e-3, least = 8e-3;  // depths [m]
  constexpr int count = 12;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto height = [c, s](const CurvePoint& p) { return c * p.z - s * p.y; };
  const double top = whereLargest(profile, height, {0, profile.length()}), z_top = height(profile.at(top));
  const double ends = std::max(height(profile.at(0)), height(profile.at(profile.length())));
  const double last = std::min(most, z_top - ends - scan_spacing);
  if (last < least)
  {
    return std::nullopt;
  }
  std::vector<ProfilePlace> middles;
  for (int i = 0; i <= count; ++i)
  {
    const double depth = first + (last - first) * i / count;
    const PointValue above = [&](const CurvePoint& p) { return height(p) - z_top + depth; };
    const auto left = firstZero(profile, above, top, 0), right = firstZero(profile, above, top, profile.length());
    if (!left || !right)
    {
      return std::nullopt;
    }
    const ProfilePlace a = placeAt(profile, *left), b = placeAt(profile, *right);
    middles.push_back({0.5 * (c * (a.y + b.y) + s * (a.z + b.z)), -depth});
  }
  return nearestLine(middles);
}

/// Lean of the axis of symmetry of a head towards the track centre [rad]; nothing if it is not symmetric.
std::optional<double> leanBySymmetry(const Profile& profile)
{
  constexpr double most = 0.1;  // [rad]
  const auto lean = [&](double angle)
  {
    const std::optional<NearestLine> line = middleLine(profile, angle);
    return line ? line->slope : 0;
  };
  if (lean(-most) * lean(most) >= 0)
  {
    return std::nullopt;
  }
  const double angle = bisected(lean, -most, most);
  const std::optional<NearestLine> line = middleLine(profile, angle);
  return line && line->deviation < straightness ? std::optional(angle) : std::nullopt;
}
}  // namespace

std::optional<double> RailMeasures::inclination() const
{
  return gauge_side_lean && field_side_lean ? std::optional(-0.5 * (*gauge_side_lean + *field_side_lean)) : axis_lean;
}

ParameterRange runningSurface(const Profile& profile, ProfileKind kind)
{
  if (kind == ProfileKind::wheel)
  {
    return {whereTip(profile), profile.length()};
  }
  const double top = whereTop(profile), z = profile.at(top).z - gauge_depth;
  return {whereHeight(profile, z, top, 0).value_or(0),
          whereHeight(profile, z, top, profile.length()).value_or(profile.length())};
}

WheelMeasures wheelMeasures(const Profile& profile)
{
  const double tip = whereTip(profile), end = profile.length();
  const double circle = firstZero(
                            profile, [](const CurvePoint& p) { return p.y; }, tip, end)
                            .value_or(end);
  WheelMeasures measures{placeAt(profile, circle), placeAt(profile, tip), {}, {}, {}, 0, {}, {}};
  measures.flange_height = measures.running_circle.z - measures.flange_tip.z;
  const auto on_front = [&](double z) { return placeAt(profile, whereHeight(profile, z, tip, circle)); };
  measures.front = on_front(measures.running_circle.z - front_depth);
  measures.upper = on_front(measures.flange_tip.z + upper_distance);
  if (measures.front)
  {
    measures.flange_back = ProfilePlace{-running_circle_distance, measures.front->z};
    measures.flange_thickness = measures.front->y - measures.flange_back->y;
  }
  if (measures.front && measures.upper)
  {
    measures.flange_gradient = measures.front->y - measures.upper->y;
  }
  return measures;
}

RailMeasures railMeasures(const Profile& profile)
{
  const double top = whereTop(profile), end = profile.length();
  RailMeasures measures{placeAt(profile, top), {}, {}, {}, {}, {}, {}, leanBySymmetry(profile)};
  const auto gauge = whereHeight(profile, measures.top.z - gauge_depth, top, 0);
  measures.gauge_side = placeAt(profile, gauge);
  measures.field_side = placeAt(profile, whereHeight(profile, measures.top.z - gauge_depth, top, end));
  if (gauge)
  {
    measures.gauge_point =
        placeAt(profile, whereLargest(profile, [](const CurvePoint& p) { return -p.y; }, {*gauge, top}));
  }
  if (measures.gauge_side && measures.field_side)
  {
    measures.head_width = measures.field_side->y - measures.gauge_side->y;
  }
  measures.gauge_side_lean = leanOfSide(profile, top, 0);
  measures.field_side_lean = leanOfSide(profile, top, end);
  return measures;
}
}  // namespace wheel_rail_contact::core
