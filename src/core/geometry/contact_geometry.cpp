// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/contact_geometry.h"

#include <algorithm>
#include <cmath>

#include "core/balance/rail_support.h"
#include "core/option_check.h"
#include "core/track/contact_search.h"
#include "core/track/placement.h"
#include "core/track/root_bracket.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double most_roll = 0.2;         ///< as WheelsetState::roll [rad]
constexpr double roll_tolerance = 1e-12;  ///< half a picometre on half the distance of the running circles [rad]
constexpr double least_step = 1e-9;       ///< of the search for a bracket of the roll [rad]

/// Rail of a side at rest, with one part.
PlacedRail runningRail(const ContactModelConfig& config, Side side, double distance)
{
  const auto& sections = config.rail_sections[side];
  const std::string rail = std::string("rail/") + nameOf(side) + "/profile";
  refuseIf(sections && sections->parts().size() != 1,
           rail + " has several parts; the contact geometry is that of one running rail per side");
  refuseIf(sections && !sections->contains(distance),
           rail + " has no section at the place " + std::to_string(distance) + " m of the line");
  return restingRail(config, side, distance);
}

/// Touch of one rigid wheel on its rail at rest.
class WheelTouch
{
 public:
  /// Keeps a reference to `config`, which must outlive the object.
  /// @param distance  place on the line, for rails with sections [m]
  /// @throw std::invalid_argument if the rail has several parts there, or its sections do not contain this place.
  WheelTouch(const ContactModelConfig& config, Side side, double distance)
      : wheel_(*config.wheel_profile[side]),
        wheelset_(config.wheelset),
        side_(side),
        rail_(runningRail(config, side, distance)),
        search_(wheel_, rail_.profile())
  {
    search_.setRail(rail_);
  }

  /// Finds the touch at y [m] and roll [rad] of the axle, track axes.
  GeometryStatus find(double y, double roll)
  {
    search_.setWheel({wheel_, wheelset_, side_, toSide(side_, {y, 0, 0, roll})});
    return !search_.nearest(touch_) ? GeometryStatus::beside_rail
           : isAtEnd()              ? GeometryStatus::off_profile
                                    : GeometryStatus::ok;
  }

  /// Height of the axle centre in the touch that was found [m].
  double height() const { return -touch_.separation; }

  /// True if points of the wheel or the rail are missing at the touch that was found.
  bool isOnMissingPoints() const
  {
    return wheel_.errorAt(touch_.wheel_u).missing || rail_.profile().errorAt(touch_.rail_u).missing;
  }

  /// Point of the touch that was found.
  TouchPoint point() const
  {
    const CurvePoint wheel = wheel_.at(touch_.wheel_u);
    const CurvePoint rail = rail_.profile().at(touch_.rail_u);
    const PlanePoint place = rail_.place(rail);
    return {sideSign(side_) * place.y,
            place.z,
            wheel.y,
            rail.y,
            std::atan(touch_.slope),
            wheelset_.rolling_radius[side_] - wheel.z};
  }

 private:
  /// True if the touch is at the end of a profile, where the bodies are cut off.
  bool isAtEnd() const
  {
    const auto is_end = [](double u, const Profile& profile)
    { return std::min(u, profile.length() - u) < ContactSearch::spacing; };
    return is_end(touch_.wheel_u, wheel_) || is_end(touch_.rail_u, rail_.profile());
  }

  const Profile& wheel_;
  const WheelsetConfig& wheelset_;
  Side side_;
  PlacedRail rail_;
  ContactSearch search_;
  InitialContact touch_;
};

/// Touch of both rigid wheels.
class WheelsetTouch
{
 public:
  /// As WheelTouch.
  WheelsetTouch(const ContactModelConfig& config, double distance)
      : wheels_(WheelTouch(config, Side::left, distance), WheelTouch(config, Side::right, distance)),
        base_(2 * config.wheelset.halfBase())
  {
  }

  /// Contact geometry at y [m].
  /// @param roll  as in ContactGeometryOptions
  GeometryPoint at(double y, bool roll)
  {
    GeometryPoint point;
    point.y = y;
    point.status = roll ? findRoll(y, point.roll) : find(y, 0);
    // Only now: the search of the roll may pass over missing points.
    if (point.status == GeometryStatus::ok && (wheels_.left.isOnMissingPoints() || wheels_.right.isOnMissingPoints()))
    {
      point.status = GeometryStatus::points_missing;
    }
    if (point.status == GeometryStatus::ok)
    {
      point.z = 0.5 * (wheels_.left.height() + wheels_.right.height());
      point.touch = {wheels_.left.point(), wheels_.right.point()};
    }
    return point;
  }

 private:
  GeometryStatus find(double y, double roll)
  {
    const GeometryStatus left = wheels_.left.find(y, roll);
    return left == GeometryStatus::ok ? wheels_.right.find(y, roll) : left;
  }

  double heightDifference() const { return wheels_.left.height() - wheels_.right.height(); }

  /// Finds the roll at which both wheels touch at the same height of the axle, the one next to zero.
  ///
  /// A roll to the left raises the left wheel: the height at which it touches falls. On a flange it may fall slowly, or
  /// rise, because the roll also moves the wheel across the track.
  GeometryStatus findRoll(double y, double& roll)
  {
    roll = 0;
    GeometryStatus status = find(y, roll);
    double difference = heightDifference();
    double step = 0;
    while (status == GeometryStatus::ok && difference != 0)
    {
      const double before = difference, roll_before = roll;
      step = std::max({std::abs(difference) / base_, 2 * step, least_step});
      roll += std::copysign(step, difference);
      if (std::abs(roll) > most_roll)
      {
        return GeometryStatus::no_roll;
      }
      status = find(y, roll);
      difference = heightDifference();
      if (status == GeometryStatus::ok && (difference > 0) != (before > 0))
      {
        const auto difference_at = [&](double trial)
        {
          const GeometryStatus found = find(y, trial);
          status = found == GeometryStatus::ok ? status : found;
          return heightDifference();
        };
        roll = bracketedRoot(difference_at, roll_before, before, roll, difference, roll_tolerance);
        return status == GeometryStatus::ok ? find(y, roll) : status;
      }
    }
    return status;
  }

  Sides<WheelTouch> wheels_;
  double base_;  ///< distance of the running circles [m]
};

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
  constexpr std::array names{"ok", "beside_rail", "off_profile", "no_roll", "points_missing"};
  return names[static_cast<std::size_t>(status)];
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
