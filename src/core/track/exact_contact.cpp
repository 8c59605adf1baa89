// SPDX-License-Identifier: BSD-3-Clause
// ContactSearch: refinement of a contact on the exact profiles. contact_search.cpp contains the rest of the class.
#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/track/contact_search.h"
#include "core/track/root_bracket.h"

namespace wheel_rail_contact::core
{
constexpr int newton_iterations = 30;
constexpr double newton_tolerance = 1e-11;   ///< [m]
constexpr double position_tolerance = 1e-8;  ///< of the position of a contact along the rail profile [m]
constexpr int most_place_steps = 5;          ///< of Newton's method for this position

/// A point and its tangent in the axes of the search.
PlanePoint ContactSearch::turned(const PlanePoint& point) const
{
  PlanePoint own = point;
  if (scope_.axes.areTurned())
  {
    scope_.axes.turn(own.y, own.z);
    scope_.axes.turn(own.dy, own.dz);
  }
  return own;
}

/// Finds the point of the wheel profile whose locus is at y.
/// @param u  parameter of the profile: initial guess; the result on return
bool ContactSearch::wheelAt(double y, double& u, CurvePoint& point, SpacePoint& locus) const
{
  double step = 0, miss_before = 0;
  for (int i = 0; i < newton_iterations; ++i)
  {
    point = wheel_->profile().at(u);
    if (!wheel_->locus(point, locus))
    {
      return false;
    }
    scope_.axes.turn(locus.y, locus.z);
    const double miss = y - locus.y;
    if (std::abs(miss) < newton_tolerance)
    {
      return true;
    }
    // Secant method. The first step uses the derivative of the profile, which is close to that of the locus.
    const double slope =
        i > 0 ? (miss_before - miss) / step : scope_.axes.cosine * point.dy + scope_.axes.sine * point.dz;
    step = miss / slope;
    miss_before = miss;
    u += step;
  }
  return false;
}

/// Evaluates both bodies at a point of the rail, on the exact profiles. On entry, `contact.wheel_u` is a guess of the
/// wheel point. @return false if a body has no suitable point there.
bool ContactSearch::exact(double rail_u, InitialContact& contact, double& slope_difference) const
{
  const CurvePoint rail_point = rail_->profile().at(rail_u);
  const PlanePoint rail = turned(rail_->place(rail_point));
  CurvePoint wheel_point{};
  SpacePoint locus{};
  PlanePoint wheel{};
  if (!(rail.dy > 0) || !wheelAt(rail.y, contact.wheel_u, wheel_point, locus) ||
      !wheel_->section(wheel_point, locus.x, wheel))
  {
    return false;
  }
  wheel = turned(wheel);
  contact.y = rail.y;
  contact.rail_u = rail_u;
  contact.separation = locus.z - rail.z;
  contact.slope = rail.dz / rail.dy;
  slope_difference = wheel.dz / wheel.dy - contact.slope;
  const double length_squared = 1 + contact.slope * contact.slope;  // of the tangent, per unit of y
  if (!along_.empty())
  {
    const AlongTouch touch = touchOf(alongAt(rail_u), wheel_point, locus.x);
    contact.separation -= touch.lift;
    slope_difference -= liftPerY(contact, wheel_point, locus.x, touch);
  }
  contact.curvature = (wheel_point.curvature() - rail_point.curvature()) * length_squared * std::sqrt(length_squared);
  return std::isfinite(contact.separation) && std::isfinite(slope_difference);
}

/// Shape of the rail along the track at a parameter of its profile [m], as heights.
AlongShape ContactSearch::alongAt(double rail_u) const
{
  constexpr double steepest = 0.2;  // cosine: beside a steeper face, the shape ends within a contact
  const CurvePoint point = rail_->profile().at(rail_u);
  const PlanePoint seen = turned(rail_->place(point));
  const AlongShape shape = rail_->along(point);
  const double per_normal = 1 / std::max(seen.dy / std::sqrt(seen.dy * seen.dy + seen.dz * seen.dz), steepest);
  return {per_normal * shape.slope, per_normal * shape.curvature};
}

/// Where a circle of the wheel touches a rail with this shape as heights. @param x0  of the locus on the circle [m]
AlongTouch ContactSearch::touchOf(const AlongShape& shape, const CurvePoint& wheel, double x0) const
{
  return {shape, x0, wheel_->sections().radius - wheel.z};
}

/// Change of the lift along y [-], with the place at which the wheel touches the prism.
double ContactSearch::liftPerY(const InitialContact& contact, const CurvePoint& wheel, double x0,
                               const AlongTouch& touch) const
{
  constexpr double step = 1e-4;  // along the profiles [m]
  const double cosine = 1 / std::sqrt(1 + contact.slope * contact.slope);
  const AlongShape before = alongAt(contact.rail_u - step), after = alongAt(contact.rail_u + step);
  const double per_y = 1 / (2 * step * cosine);
  double lift = per_y * (after.at(touch.x) - before.at(touch.x));
  SpacePoint beside{};
  const CurvePoint next = wheel_->profile().at(contact.wheel_u + step);
  if (wheel_->pose().yaw != 0 && wheel_->locus(next, beside))
  {
    const double dy = scope_.axes.cosine * (next.y - wheel.y) + scope_.axes.sine * (next.z - wheel.z);
    const AlongShape here = alongAt(contact.rail_u);
    lift += here.slopeAt(touch.x) * (beside.x - x0) / dy;
  }
  return lift;
}

/// True if a contact is next to its station and not higher. Where an outline hides a fold of its profile, the path
/// along the profile from one station to the next may lead to another contact.
bool ContactSearch::isNear(const InitialContact& contact, std::size_t k) const
{
  return std::abs(contact.y - stations_.y(k)) < 1.5 * spacing &&
         contact.separation < separation_[k] + 4 * station_error;
}

/// Finds the contact near a station by Newton's method, starting at the lowest point of the parabola through the
/// separations there. @return false unless it converges to a minimum between the neighbouring stations.
bool ContactSearch::findByNewton(std::size_t k, InitialContact& contact) const
{
  const auto [before, after] = neighbours(k);
  if (before == k || after == k)
  {
    return false;
  }
  const double aft = separation_[k - 1] - separation_[k];
  const double fore = separation_[k + 1] - separation_[k];
  if (!(aft + fore > 0 && aft + fore < infinity))
  {
    return false;
  }
  const double rail_per_y = (rail_outline_.u(k + 1) - rail_outline_.u(k - 1)) / (2 * spacing);
  const double wheel_per_y = (wheel_outline_.u(k + 1) - wheel_outline_.u(k - 1)) / (2 * spacing);
  double step = 0.5 * spacing * (aft - fore) / (aft + fore);
  double rail_u = rail_outline_.u(k);
  contact.wheel_u = wheel_outline_.u(k);
  for (int i = 0; i < most_place_steps; ++i)
  {
    rail_u += step * rail_per_y;
    contact.wheel_u += step * wheel_per_y;
    double slope_difference = 0;
    if (!exact(rail_u, contact, slope_difference))
    {
      return false;
    }
    step = -slope_difference / contact.curvature;
    if (!(contact.curvature > 0) || !(std::abs(contact.y + step - stations_.y(k)) < spacing))
    {
      return false;
    }
    if (std::abs(step * rail_per_y) < position_tolerance)
    {
      return true;
    }
  }
  return false;
}

/// Contact near a station: the position between the neighbouring stations at which the difference of the slopes changes
/// its sign. The station itself if there is none.
InitialContact ContactSearch::refined(std::size_t k) const
{
  if (k == nearest_station_)
  {
    return nearest_;
  }
  InitialContact trial;
  if (findByNewton(k, trial) && isNear(trial, k))
  {
    return trial;
  }
  const auto [before, after] = neighbours(k);
  double difference = 0;
  bool found = false;
  const auto slope_difference_at = [&](double rail_u)
  {
    found = exact(rail_u, trial, difference);
    return found ? difference : 0.0;
  };
  const auto slope_difference_over = [&](std::size_t station)
  {
    trial.wheel_u = wheel_outline_.u(station);
    return separation_[station] < infinity ? slope_difference_at(rail_outline_.u(station)) : 0.0;
  };
  const double low = slope_difference_over(before);
  const double high = slope_difference_over(after);
  trial.wheel_u = wheel_outline_.u(k);
  const bool bracketed = low < 0 && high > 0;
  if (bracketed)
  {
    bracketedRoot(slope_difference_at, rail_outline_.u(before), low, rail_outline_.u(after), high, position_tolerance);
  }
  if (!bracketed || !found || !isNear(trial, k))
  {
    trial.wheel_u = wheel_outline_.u(k);
    slope_difference_at(rail_outline_.u(k));
  }
  return found ? trial : InitialContact{stations_.y(k), separation_[k], 0, 0, wheel_outline_.u(k), rail_outline_.u(k)};
}

bool ContactSearch::nearest(InitialContact& contact)
{
  if (minima_.empty())
  {
    return false;
  }
  const std::size_t lowest =
      *std::min_element(minima_.begin(), minima_.end(),
                        [this](std::size_t one, std::size_t other) { return separation_[one] < separation_[other]; });
  contact = refined(lowest);
  std::size_t station = lowest;
  for (const std::size_t k : minima_)
  {
    if (k != lowest && separation_[k] - depthBelowStation(k) < contact.separation)
    {
      const InitialContact other = refined(k);
      if (other.separation < contact.separation)
      {
        contact = other;
        station = k;
      }
    }
  }
  nearest_ = contact;
  nearest_station_ = station;
  return true;
}
}  // namespace wheel_rail_contact::core
