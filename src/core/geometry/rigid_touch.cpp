// SPDX-License-Identifier: BSD-3-Clause
#include "core/geometry/rigid_touch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/balance/rail_support.h"
#include "core/track/bracketed_root.h"

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
  if (sections && sections->parts().size() != 1)
  {
    throw std::invalid_argument(rail + " has several parts; the contact geometry is that of one running rail per side");
  }
  if (sections && !sections->contains(distance))
  {
    throw std::invalid_argument(rail + " has no section at the place " + std::to_string(distance) + " m of the line");
  }
  return restingRail(config, side, distance);
}
}  // namespace

WheelTouch::WheelTouch(const ContactModelConfig& config, Side side, double distance)
    : wheel_(*config.wheel_profile[side]),
      wheelset_(config.wheelset),
      side_(side),
      rail_(runningRail(config, side, distance)),
      search_(wheel_, rail_.profile())
{
  search_.setRail(rail_);
}

GeometryStatus WheelTouch::find(double y, double roll)
{
  search_.setWheel({wheel_, wheelset_, side_, toSide(side_, {y, 0, 0, roll})});
  if (!search_.nearest(touch_))
  {
    return GeometryStatus::beside_rail;
  }
  return isAtEnd() ? GeometryStatus::off_profile : GeometryStatus::ok;
}

/// True if the touch is at the end of a profile, where the bodies are cut off.
bool WheelTouch::isAtEnd() const
{
  const auto is_end = [](double u, const Profile& profile)
  { return std::min(u, profile.length() - u) < ContactSearch::spacing; };
  return is_end(touch_.wheel_u, wheel_) || is_end(touch_.rail_u, rail_.profile());
}

bool WheelTouch::isOnMissingPoints() const
{
  return wheel_.errorAt(touch_.wheel_u).missing || rail_.profile().errorAt(touch_.rail_u).missing;
}

TouchPoint WheelTouch::point() const
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

WheelsetTouch::WheelsetTouch(const ContactModelConfig& config, double distance)
    : wheels_{{config, Side::left, distance}, {config, Side::right, distance}}, base_(2 * config.wheelset.halfBase())
{
}

GeometryStatus WheelsetTouch::find(double y, double roll)
{
  const GeometryStatus left = wheels_.left.find(y, roll);
  return left == GeometryStatus::ok ? wheels_.right.find(y, roll) : left;
}

/// Finds the roll at which both wheels touch at the same height of the axle, the one next to zero.
///
/// A roll to the left raises the left wheel: the height at which it touches falls. On a flange it may fall slowly, or
/// rise, because the roll also moves the wheel across the track.
GeometryStatus WheelsetTouch::findRoll(double y, double& roll)
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

GeometryPoint WheelsetTouch::at(double y, bool roll)
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
}  // namespace wheel_rail_contact::core
