// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/contact_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/geometry/rigid_touch.h"
#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double farthest_y = 0.1;        ///< from the track centre, as WheelsetState::y [m]
constexpr double most_steps = 20000;      ///< of the lateral displacement
constexpr double curve_tolerance = 2e-7;  ///< of straight lines between the points of the curve [m]
constexpr double least_interval = 1e-7;   ///< in y, between two points of the curve [m]
constexpr double step_round_off = 1e-6;   ///< in the number of steps

void validate(const ContactGeometryOptions& options)
{
  requireWithin("y_first", options.y_first, farthest_y, "must be within ±0.1 m");
  requireWithin("y_last", options.y_last, farthest_y, "must be within ±0.1 m");
  requirePositive("y_step", options.y_step);
  require(options.y_last > options.y_first, "y_last", options.y_last, "must be above y_first");
  require(options.y_last - options.y_first <= most_steps * options.y_step, "y_step", options.y_step,
          "gives more than 20000 steps");
  require(std::isfinite(options.distance), "distance", options.distance, "must be a number");
}

/// Lateral displacements from y_first to y_last [m]: multiples of the step, including an exact zero, if y_first is one.
std::vector<double> displacements(const ContactGeometryOptions& options)
{
  const double whole = std::round(options.y_first / options.y_step);
  const bool is_multiple = std::abs(options.y_first / options.y_step - whole) < step_round_off;
  const double start = is_multiple ? whole : options.y_first / options.y_step;
  const double steps = (options.y_last - options.y_first) / options.y_step;
  std::vector<double> result;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps + step_round_off); ++i)
  {
    result.push_back((start + static_cast<double>(i)) * options.y_step);
  }
  return result;
}

/// The curve of the rolling radius difference, refined between neighbouring points with a result.
class CurveRefinement
{
 public:
  CurveRefinement(WheelsetTouch& touch, bool roll) : touch_(touch), roll_(roll) {}

  /// Longest uninterrupted range of points with a result, refined.
  std::vector<RadiusDifference> longest(const std::vector<GeometryPoint>& points)
  {
    std::vector<RadiusDifference> longest;
    for (const GeometryPoint& point : points)
    {
      if (point.status != GeometryStatus::ok)
      {
        keepLonger(longest);
        continue;
      }
      const RadiusDifference end{point.y, point.radiusDifference()};
      if (!curve_.empty() && !refineTo(end))
      {
        keepLonger(longest);
      }
      curve_.push_back(end);
    }
    keepLonger(longest);
    return longest;
  }

 private:
  static double width(const std::vector<RadiusDifference>& curve)
  {
    return curve.empty() ? 0 : curve.back().y - curve.front().y;
  }

  void keepLonger(std::vector<RadiusDifference>& longest)
  {
    if (width(curve_) > width(longest))
    {
      longest = curve_;
    }
    curve_.clear();
  }

  /// Adds points between the last one and `end`. @return false if one of them has no result
  bool refineTo(const RadiusDifference& end)
  {
    const RadiusDifference begin = curve_.back();
    if (end.y - begin.y < least_interval)
    {
      return true;
    }
    const GeometryPoint middle = touch_.at(0.5 * (begin.y + end.y), roll_);
    if (middle.status != GeometryStatus::ok)
    {
      return false;
    }
    const RadiusDifference half{middle.y, middle.radiusDifference()};
    if (std::abs(half.value - 0.5 * (begin.value + end.value)) < curve_tolerance)
    {
      return true;
    }
    if (!refineTo(half))
    {
      return false;
    }
    curve_.push_back(half);
    return refineTo(end);
  }

  WheelsetTouch& touch_;
  bool roll_;
  std::vector<RadiusDifference> curve_;
};
}  // namespace

const char* toString(GeometryStatus status)
{
  switch (status)
  {
    case GeometryStatus::beside_rail:
      return "beside_rail";
    case GeometryStatus::off_profile:
      return "off_profile";
    case GeometryStatus::no_roll:
      return "no_roll";
    case GeometryStatus::points_missing:
      return "points_missing";
    case GeometryStatus::ok:
      break;
  }
  return "ok";
}

ContactGeometry contactGeometry(const ContactModelConfig& config, const ContactGeometryOptions& options)
{
  validate(config);
  validate(options);
  WheelsetTouch touch(config, options.distance);
  ContactGeometry geometry;
  for (const double y : displacements(options))
  {
    geometry.points.push_back(touch.at(y, options.roll));
  }
  geometry.curve = CurveRefinement(touch, options.roll).longest(geometry.points);
  return geometry;
}
}  // namespace wheel_rail_contact::core
