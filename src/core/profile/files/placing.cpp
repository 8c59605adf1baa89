// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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
/// Least height of a whole rail, and depth of its head [m].
constexpr double whole_height = 0.120, head_depth = 0.040;
constexpr double foot_ratio = 1.3;  ///< least ratio of the widths of foot and head

double topOf(const Points& points)
{
  return std::max_element(points.begin(), points.end(), isLower)->z;
}

/// Range of y of the points at most `depth` below the top.
std::pair<double, double> widthAt(const Points& points, double depth)
{
  const double least = topOf(points) - depth;
  std::pair<double, double> range{INFINITY, -INFINITY};
  for (const SampledPoint& p : points)
  {
    if (p.z >= least)
    {
      range = {std::min(range.first, p.y), std::max(range.second, p.y)};
    }
  }
  return range;
}

/// Depth down to which both sides of the head are there, at most gauge_depth.
double commonDepth(const Points& points)
{
  const double top = topOf(points);
  return std::min({gauge_depth, top - points.front().z, top - points.back().z});
}

/// y of the middle of the head; nothing if one of its sides is not there.
std::optional<double> middleOf(const Points& points)
{
  const double depth = commonDepth(points);
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

/// True if points are the outline of a rail with its foot.
bool isWholeRail(const Points& points)
{
  const auto [bottom, top] = std::minmax_element(points.begin(), points.end(), isLower);
  const auto width = [&points](double depth)
  {
    const auto [left, right] = widthAt(points, depth);
    return right - left;
  };
  const double height = top->z - bottom->z;
  return height > whole_height && width(height) > foot_ratio * width(head_depth);
}

/// Keeps the head of the whole outline of a rail: from the top down to where both sides are widest.
void cutToHead(Points& points)
{
  const auto bottom = std::min_element(points.begin(), points.end(), isLower);
  std::rotate(points.begin(), bottom, points.end());
  const auto highest = std::max_element(points.begin(), points.end(), isLower);
  const double least = highest->z - head_depth;
  const auto is_below = [least](const SampledPoint& p) { return p.z < least; };
  const auto last = std::find_if(highest, points.end(), is_below);
  const auto first = std::find_if(std::make_reverse_iterator(highest), points.rend(), is_below).base();
  const auto [left, right] = std::minmax_element(first, last, isFartherInward);
  points = Points(std::min(left, right), std::max(left, right) + 1);
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

/// @throw FileError if the points do not extend across the running circle that the file states.
void placeWheel(const TextFile& file, const FileProfile& content, std::optional<Origin> origin, PlacedPoints& placed)
{
  const double stated = content.running_circle;
  const bool from_back = origin ? *origin == Origin::flange_back : stated != 0;
  const auto [left, right] = std::minmax_element(placed.points.begin(), placed.points.end(), isFartherInward);
  if (from_back && stated != 0 && !placed.points.empty() && (left->y > stated || right->y < stated))
  {
    file.refuse(0, "points from X = " + millimetres(left->y) + " to " + millimetres(right->y) +
                       " do not extend across the running circle, X = " + millimetres(stated) +
                       " (WheelDiameterTaperline): X must be counted from the flange back to the field side");
  }
  if (from_back)
  {
    move(-(stated != 0 ? stated : running_circle_distance), 0, placed);
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
  if (reading.origin)
  {
    checkOrigin(file, kind, *reading.origin);
  }
  if (kind == ProfileKind::wheel)
  {
    placeWheel(file, content, reading.origin, placed);
  }
  else if (kind == ProfileKind::rail && !placed.points.empty())
  {
    if (isWholeRail(placed.points))
    {
      cutToHead(placed.points);
    }
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
