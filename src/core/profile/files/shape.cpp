// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/profile/files/steps.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
namespace
{
using Points = std::vector<SampledPoint>;

// Bounds of a plausible profile [m].
constexpr std::size_t fewest_points = 10;
constexpr double least_width = 0.020;
constexpr double most_width = 0.300;
constexpr double most_height = 0.120;
/// Largest height of a wheel profile over its running circle, at y = 0 [m]. Wear is less.
constexpr double running_circle_tolerance = 0.005;
/// Least depth of the flange tip below the running circle and below the field side [m].
constexpr double least_flange_height = 0.010;
/// Greatest height of a tread over the running circle, and least distance of a higher rim from it [m].
constexpr double highest_tread = 0.012, nearest_rim = 0.045;
/// Least height of a flange tip over the flange back, by which a flange on the field side is detected [m].
constexpr double least_back_rise = 0.003;
/// y of a flange tip above which y counts from the flange back rather than from the running circle [m].
constexpr double farthest_tip = -0.020;
constexpr double nearest_axle_centre = 0.1;  ///< a tip farther outward is not measured from the flange back [m]
/// Range of y of the front of a flange, at the least depth of the flange below the running circle [m]. New and worn
/// flanges of main lines and trams are within -0.053 to -0.032.
constexpr double first_front = -0.055, last_front = -0.030;
/// Longest flat part of a rail deeper than a depth below its top, and its slope [m, m, -]. The tread of a wheel that
/// points down lies deep below its flange.
constexpr double longest_flat = 0.025, flat_depth = 0.015, flat_slope = 0.2;

struct Box
{
  explicit Box(const Points& points)
  {
    const auto [left, right] = std::minmax_element(points.begin(), points.end(), isFartherInward);
    const auto [bottom, top] = std::minmax_element(points.begin(), points.end(), isLower);
    y_min = left->y;
    y_max = right->y;
    lowest = *bottom;
    highest = *top;
  }
  double width() const { return y_max - y_min; }
  /// Relative position across the profile: 0 at its smallest y, 1 at its largest y.
  double share(double y) const { return (y - y_min) / width(); }

  double y_min, y_max;
  SampledPoint lowest, highest;
};

void checkExtent(const TextFile& file, const Points& points)
{
  const double width = Box(points).width();
  const double between_ends = points.back().y - points.front().y;
  file.refuseIf(between_ends < 0.7 * width, 0,
                "ends are " + millimetres(between_ends) + " apart, profile is " + millimetres(width) +
                    " wide: a closed outline or not a profile");
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += distance(points[i - 1], points[i]);
  }
  file.refuseIf(length > 3.0 * width, 0,
                "curve is " + millimetres(length) + " long, profile is " + millimetres(width) +
                    " wide: points not in order along the profile or not a profile");
}

/// Height of the tread at the running circle [m]; 0 if the curve does not reach it.
double heightOfTread(const Points& points)
{
  const double height = heightAtOrigin(points);
  return std::isinf(height) ? 0 : height;
}

/// y at which the front of the flange is at a depth below the running circle [m]; infinite if it is not there.
double frontOfFlange(const Points& points, double depth)
{
  for (std::size_t i = points.size() - 1; i > 0; --i)
  {
    const SampledPoint &a = points[i - 1], &b = points[i];
    if (b.y < 0 && a.z <= -depth && b.z > -depth)
    {
      return a.y + (b.y - a.y) * (-depth - a.z) / (b.z - a.z);
    }
  }
  return INFINITY;
}

void checkRunningCircle(const TextFile& file, const Points& points)
{
  const double height = heightAtOrigin(points);
  file.refuseIf(std::isinf(height), 0, "profile does not cross y = 0, where the running circle must be");
  file.refuseIf(!(std::abs(height) <= running_circle_tolerance), 0,
                "profile is " + millimetres(height) +
                    " above its origin at y = 0, which must be the running circle, within " +
                    millimetres(running_circle_tolerance) + "; a shift of z moves it");
  const double front = frontOfFlange(points, least_flange_height);
  file.refuseIf(!std::isinf(front) && !(front >= first_front && front <= last_front), 0,
                "front of the flange, " + millimetres(least_flange_height) + " below the running circle, is at y = " +
                    millimetres(front) + ", must be from " + millimetres(first_front) + " to " +
                    millimetres(last_front) + ": the origin is not the running circle; a shift of y moves it");
  // A wheel that is rotated by 180 degrees has its tread as before, but its flange points up, on the field side.
  file.refuseIf(Box(points).lowest.z > -least_flange_height, 0,
                "no flange reaches " + millimetres(least_flange_height) +
                    " below the running circle: not a wheel, or both axes are reversed");
}

/// Length of the parts of a curve that are flat and deep below its top [m].
double deepFlatLength(const Points& points, double top)
{
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const SampledPoint &a = points[i - 1], &b = points[i];
    const bool is_flat = std::abs(b.z - a.z) < flat_slope * std::abs(b.y - a.y);
    length += is_flat && b.z < top - flat_depth ? distance(points[i - 1], points[i]) : 0;
  }
  return length;
}

void checkRail(const TextFile& file, const Points& points)
{
  const Box box(points);
  const double top = box.share(box.highest.y);
  file.refuseIf(!(top > 0.05 && top < 0.95), 0,
                "highest point is at an end: not a rail, or z does not point up. A check rail or a section of a "
                "crossing is a part of a rail (rail/profile/parts)");
  const double bottom = box.share(box.lowest.y);
  file.refuseIf(bottom > 0.08 && bottom < 0.92, 0, "lowest point is not at an end: not a rail");
  file.refuseIf(deepFlatLength(points, box.highest.z) > longest_flat, 0,
                "a flat part lies more than " + millimetres(flat_depth) +
                    " below the top: not a rail, but perhaps a wheel with z reversed");
}

/// A section of a rail turned upside down is a bowl.
void checkSection(const TextFile& file, const Points& points)
{
  const Box box(points);
  const auto is_end = [&](const SampledPoint& point)
  { return point.z == points.front().z || point.z == points.back().z; };
  file.refuseIf(is_end(box.highest) && !is_end(box.lowest), 0,
                "highest point is at an end, lowest point is not: z does not point as the format requires");
}

/// True if the field side has a tip that is lower than a flange must be, with a back behind it. A rim has no back.
bool flangeOnFieldSide(const Points& points)
{
  const auto field = std::find_if(points.begin(), points.end(), [](const SampledPoint& p) { return p.y > 0; });
  const auto tip = std::min_element(field, points.end(), isLower);
  return tip != points.end() && tip->z < heightOfTread(points) - least_flange_height &&
         points.back().z - tip->z > least_back_rise;
}

/// True if the field side has a tip that is higher than a tread, with a back behind it or close to the running circle.
/// The end of a rim rises, too, but farther out, and it does not fall again.
bool flangePointsUp(const Points& points)
{
  const double least = heightOfTread(points) + highest_tread;
  const auto field = std::find_if(points.begin(), points.end(), [](const SampledPoint& p) { return p.y > 0; });
  const auto tip = std::max_element(field, points.end(), isLower);
  const auto high = std::find_if(field, points.end(), [least](const SampledPoint& p) { return p.z > least; });
  return high != points.end() && (tip->z - points.back().z > least_back_rise || high->y < nearest_rim);
}

void checkFlange(const TextFile& file, const Points& points)
{
  const Box box(points);
  const double place = box.share(box.lowest.y);
  file.refuseIf(place > 0.6, 0,
                "lowest point is on the field side: not a wheel with its flange on the gauge side, or an axis is "
                "reversed");
  file.refuseIf(
      place <= 0.4 && box.lowest.y > farthest_tip, 0,
      "flange tip is at y = " + millimetres(box.lowest.y) +
          (box.lowest.y > nearest_axle_centre
               ? ": y is from the axle centre; give shift: {y: -0.75}, half the distance of the running circles"
               : ": the origin is not the running circle; if it is the flange back, give origin: flange_back"));
  file.refuseIf(flangeOnFieldSide(points), 0, "flange is on the field side: y is reversed");
  file.refuseIf(flangePointsUp(points), 0, "a flange points up on the field side: both axes are reversed");
  file.refuseIf(points.back().z - box.lowest.z < least_flange_height || place > 0.4, 0,
                "no flange of at least " + millimetres(least_flange_height) + " on the gauge side: not a wheel");
}
}  // namespace

void checkSize(const TextFile& file, const Points& points)
{
  file.refuseIf(
      points.size() < fewest_points, 0,
      "number of points is " + std::to_string(points.size()) + ", must be at least " + std::to_string(fewest_points));
  const Box box(points);
  const double height = box.highest.z - box.lowest.z;
  file.refuseIf(!(box.width() >= least_width && box.width() <= most_width), 0,
                "profile is " + millimetres(box.width()) + " wide, must be " + millimetres(least_width) + " to " +
                    millimetres(most_width) + ": wrong unit or not a profile");
  file.refuseIf(!(height <= most_height), 0,
                "profile is " + millimetres(height) + " high, must be at most " + millimetres(most_height) +
                    ": wrong unit or not a profile");
}

void checkShape(const TextFile& file, const std::vector<SampledPoint>& points, ProfileKind kind)
{
  checkExtent(file, points);
  switch (kind)
  {
    case ProfileKind::wheel:
      checkFlange(file, points);
      checkRunningCircle(file, points);
      break;
    case ProfileKind::rail:
      checkRail(file, points);
      break;
    default:
      checkSection(file, points);
  }
}
}  // namespace wheel_rail_contact::core
