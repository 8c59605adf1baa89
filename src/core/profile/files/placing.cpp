// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/profile/curve/measures.h"
#include "core/profile/files/steps.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
namespace
{
using Points = std::vector<SampledPoint>;
using Origin = ProfileReading::Origin;

/// Range of the height of the top of a rail over the origin that counts as the crown: a rail wears down [m].
constexpr double highest_top = 0.005, lowest_top = -0.020;
/// Largest distance of the middle of the head from an origin on the crown [m]: worn and inclined rails have up to 6 mm.
constexpr double farthest_middle = 0.015;
/// Least depth at which both sides must be there to find the middle [m].
constexpr double least_side_depth = 0.001;
constexpr double taper_line_tolerance = 0.5e-3;  ///< of a stated taper line [m]

double topOf(const Points& points)
{
  return std::max_element(points.begin(), points.end(), isLower)->z;
}

/// y of the middle of the head, down to the depth at which both sides are there; nothing if one of its sides is not.
std::optional<double> middleOf(const Points& points)
{
  const double top = topOf(points);
  const double depth = std::min({gauge_depth, top - points.front().z, top - points.back().z});
  if (depth < least_side_depth)
  {
    return std::nullopt;
  }
  const auto [left, right] = widthAt(points, depth);
  return 0.5 * (left + right);
}

void move(double y, double z, PlacedPoints& placed)
{
  for (SampledPoint& p : placed.points)
  {
    p.y += y;
    p.z += z;
  }
  placed.moved_y += y;
  placed.moved_z += z;
}

/// Height at y = 0 of the line through the point `before` and the next one [m]; y = 0 is between them.
double lineBetween(const Points& points, std::size_t before)
{
  const SampledPoint &a = points[before], &b = points[before + 1];
  return a.z + (b.z - a.z) * (-a.y) / (b.y - a.y);
}

/// Height at y = 0 of the cubic through the four nearest points [m]; that of the line if two of them have the same y.
double cubicBetween(const Points& points, std::size_t before)
{
  constexpr std::size_t count = 4;
  if (points.size() < count)
  {
    return lineBetween(points, before);
  }
  const std::size_t first = std::min(before - std::min<std::size_t>(before, 1), points.size() - count);
  double height = 0;
  for (std::size_t i = first; i < first + count; ++i)
  {
    double weight = 1;
    for (std::size_t k = first; k < first + count; ++k)
    {
      weight *= k == i ? 1 : points[k].y / (points[k].y - points[i].y);
    }
    height += weight * points[i].z;
  }
  return std::isfinite(height) ? height : lineBetween(points, before);
}

/// @throw FileError if the running circle that the file states is another one, or the points do not extend across it.
void placeWheel(const TextFile& file, const FileProfile& content, const ProfileReading& reading, PlacedPoints& placed)
{
  const double stated = content.running_circle, given = reading.tape_circle.value_or(stated);
  file.refuseIf(
      stated != 0 && std::abs(stated - given) > taper_line_tolerance, 0,
      "WheelDiameterTaperline = " + millimetres(stated) + " contradicts wheelset/tape_circle = " + millimetres(given));
  const bool from_back =
      reading.origin ? *reading.origin == Origin::flange_back : stated != 0 || content.from_flange_back;
  const auto [left, right] = std::minmax_element(placed.points.begin(), placed.points.end(), isFartherInward);
  const double circle = stated != 0 ? stated : reading.tape_circle.value_or(running_circle_distance);
  if (from_back && !placed.points.empty() && (left->y > circle || right->y < circle))
  {
    file.refuse(0, "points from X = " + millimetres(left->y) + " to " + millimetres(right->y) +
                       " do not extend across the running circle, X = " + millimetres(circle) +
                       " (WheelDiameterTaperline or wheelset/tape_circle): X must be counted from the flange back to "
                       "the field side");
  }
  if (from_back)
  {
    move(-circle, 0, placed);
    const double height = heightAtOrigin(placed.points);
    move(0, std::isinf(height) ? 0 : -height, placed);
  }
}

/// @throw FileError if an origin does not belong to the kind of profile.
void checkOrigin(const TextFile& file, ProfileKind kind, Origin origin)
{
  const bool of_wheel = origin == Origin::running_circle || origin == Origin::flange_back;
  file.refuseIf(kind == ProfileKind::rail_section, 0,
                "origin must not be stated for a section of a rail: it keeps its coordinates; shift moves it");
  file.refuseIf(of_wheel != (kind == ProfileKind::wheel), 0,
                of_wheel ? "origin running_circle or flange_back belongs to a wheel, not to a rail"
                         : "origin crown, gauge_corner or foot belongs to a rail, not to a wheel");
}

void placeRail(const TextFile& file, std::optional<Origin> origin, PlacedPoints& placed)
{
  const double top = topOf(placed.points);
  const bool is_crown = top <= highest_top && top >= lowest_top;
  if (origin ? *origin != Origin::crown : !is_crown)
  {
    move(0, -top, placed);
  }
  if (origin && *origin != Origin::gauge_corner)
  {
    return;
  }
  const std::optional<double> middle = middleOf(placed.points);
  file.refuseIf(origin && !middle, 0,
                "one side of the head is missing: its middle is not known; give shift instead of origin");
  if (middle && (origin || std::abs(*middle) > farthest_middle))
  {
    move(-*middle, 0, placed);
  }
}
}  // namespace

double heightAtOrigin(const std::vector<SampledPoint>& points)
{
  double nearest = INFINITY;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    if ((points[i - 1].y <= 0.0) != (points[i].y <= 0.0))
    {
      const double height = cubicBetween(points, i - 1);
      nearest = std::abs(height) < std::abs(nearest) ? height : nearest;
    }
  }
  return nearest;
}

PlacedPoints placedPoints(const TextFile& file, const FileProfile& content, ProfileKind kind, const FileAxes& axes,
                          const ProfileReading& reading)
{
  PlacedPoints placed{content.points};
  const double y_factor = axes.y == ProfileReading::Y::outward ? axes.unit : -axes.unit;
  const double z_factor = axes.z == ProfileReading::Z::up ? axes.unit : -axes.unit;
  for (SampledPoint& p : placed.points)
  {
    p.y *= y_factor;
    p.z *= z_factor;
    file.refuseIf(!std::isfinite(p.y) || !std::isfinite(p.z), p.line, "coordinate of the point is too large");
  }
  placed.remark = averageCloud(file, kind, placed.points);
  if (reading.origin)
  {
    checkOrigin(file, kind, *reading.origin);
  }
  if (kind == ProfileKind::wheel)
  {
    placeWheel(file, content, reading, placed);
  }
  else if (kind == ProfileKind::rail && !placed.points.empty())
  {
    const std::string head = keepHead(file, placed.points);
    placed.remark += (placed.remark.empty() || head.empty() ? "" : ", ") + head;
    placeRail(file, reading.origin, placed);
  }
  move(reading.shift_y, reading.shift_z, placed);
  rotate(reading.rotate, placed.points);
  for (SampledPoint& p : placed.points)
  {
    p.y *= reading.mirror ? -1 : 1;
  }
  return placed;
}
}  // namespace wheel_rail_contact::core
