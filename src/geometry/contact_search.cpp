// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/geometry/contact_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "bracketed_root.h"

namespace wheel_rail_contact
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int newton_iterations = 30;
constexpr double newton_tolerance = 1e-11;  ///< [m]
constexpr double root_tolerance = 1e-8;     ///< of a contact's place across the track [m]
constexpr std::size_t fine_stations = 4;    ///< stretches of fewer stations are measured by their curvature

/// Parameters about `spacing` apart over the whole profile, and the points there.
void sample(const Profile& profile, double spacing, Eigen::ArrayXd& u, std::vector<CurvePoint>& points)
{
  const auto count = std::max(2L, std::lround(profile.length() / spacing) + 1);
  u = Eigen::ArrayXd::LinSpaced(count, 0, profile.length());
  points.resize(static_cast<std::size_t>(count));
  std::transform(u.begin(), u.end(), points.begin(), [&](double value) { return profile.at(value); });
}

/// Equidistant stations y = first + k spacing.
struct Stations
{
  double first;
  double spacing;
};

/// Writes the straight segment from (y0, z0, u0) to (y1, z1, u1) into the outline where `nearer(new, old)`.
template <typename Nearer>
void writeSegment(const Stations& stations, double y0, double z0, double u0, double y1, double z1, double u1,
                  Nearer nearer, Outline& outline)
{
  const auto count = static_cast<long>(outline.z.size());
  const long first = std::max(0L, static_cast<long>(std::ceil((std::min(y0, y1) - stations.first) / stations.spacing)));
  const long last =
      std::min(count - 1, static_cast<long>(std::floor((std::max(y0, y1) - stations.first) / stations.spacing)));
  for (long k = first; k <= last; ++k)
  {
    const double y = stations.first + static_cast<double>(k) * stations.spacing;
    const double share = y1 == y0 ? 0 : (y - y0) / (y1 - y0);
    const double z = z0 + share * (z1 - z0);
    const auto at = static_cast<std::size_t>(k);
    if (nearer(z, outline.z[at]))
    {
      outline.z[at] = z;
      outline.u[at] = u0 + share * (u1 - u0);
    }
  }
}
}  // namespace

ContactSearch::ContactSearch(const Profile& wheel, const Profile& rail)
{
  sample(wheel, spacing, wheel_u_, wheel_points_);
  sample(rail, spacing, rail_u_, rail_points_);
  wheel_locus_.resize(wheel_points_.size());
}

void ContactSearch::setRail(const PlacedRail& rail)
{
  rail_ = rail;
  double low = infinity;
  double high = -infinity;
  for (const CurvePoint& point : rail_points_)
  {
    const double y = rail.place(point).y;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  const auto count = static_cast<std::size_t>((high - low) / spacing) + 2;
  y_first_ = low;
  rail_outline_.z.assign(count, -infinity);
  rail_outline_.u.assign(count, 0);
  wheel_outline_.z.resize(count);
  wheel_outline_.u.resize(count);
  separation_.resize(count);
  PlanePoint before = rail.place(rail_points_.front());
  for (std::size_t i = 1; i < rail_points_.size(); ++i)
  {
    const PlanePoint here = rail.place(rail_points_[i]);
    const auto at = static_cast<Eigen::Index>(i);
    writeSegment({y_first_, spacing}, before.y, before.z, rail_u_[at - 1], here.y, here.z, rail_u_[at],
                 std::greater<double>(), rail_outline_);
    before = here;
  }
}

void ContactSearch::setWheel(const PlacedWheel& wheel)
{
  wheel_ = wheel;
  std::fill(wheel_outline_.z.begin(), wheel_outline_.z.end(), infinity);
  SpacePoint before{};
  bool has_before = false;
  for (std::size_t i = 0; i < wheel_points_.size(); ++i)
  {
    SpacePoint here;
    const bool has_here = wheel.locus(wheel_points_[i], here);
    if (has_before && has_here)
    {
      const auto at = static_cast<Eigen::Index>(i);
      writeSegment({y_first_, spacing}, before.y, before.z, wheel_u_[at - 1], here.y, here.z, wheel_u_[at],
                   std::less<double>(), wheel_outline_);
    }
    before = here;
    has_before = has_here;
  }
  std::transform(wheel_outline_.z.begin(), wheel_outline_.z.end(), rail_outline_.z.begin(), separation_.begin(),
                 std::minus<double>());
}

bool ContactSearch::isMinimum(std::size_t k) const
{
  const double here = separation_[k];
  const double before = k > 0 ? separation_[k - 1] : infinity;
  const double after = k + 1 < separation_.size() ? separation_[k + 1] : infinity;
  return here < infinity && here <= before && here < after;
}

bool ContactSearch::railAt(double y, double& u) const
{
  for (int i = 0; i < newton_iterations; ++i)
  {
    const PlanePoint rail = rail_->at(u);
    const double miss = y - rail.y;
    if (std::abs(miss) < newton_tolerance)
    {
      return true;
    }
    u += miss / rail.dy;
  }
  return false;
}

bool ContactSearch::wheelAt(double y, double& u, SpacePoint& locus) const
{
  double step = 0;
  double miss_before = 0;
  for (int i = 0; i < newton_iterations; ++i)
  {
    const CurvePoint point = wheel_->profile().at(u);
    if (!wheel_->locus(point, locus))
    {
      return false;
    }
    const double miss = y - locus.y;
    if (std::abs(miss) < newton_tolerance)
    {
      return true;
    }
    // Secant on the locus; to start with, its derivative is close to that of the profile.
    const double slope = i > 0 ? (miss_before - miss) / step : point.dy;
    step = miss / slope;
    miss_before = miss;
    u += step;
  }
  return false;
}

bool ContactSearch::exact(double y, std::size_t k, InitialContact& contact, double& slope_difference) const
{
  contact.y = y;
  contact.wheel_u = wheel_outline_.u[k];
  contact.rail_u = rail_outline_.u[k];
  SpacePoint locus{};
  if (!railAt(y, contact.rail_u) || !wheelAt(y, contact.wheel_u, locus))
  {
    return false;
  }
  const PlanePoint rail = rail_->at(contact.rail_u);
  const CurvePoint wheel_point = wheel_->profile().at(contact.wheel_u);
  PlanePoint wheel;
  if (!wheel_->section(wheel_point, locus.x, wheel))
  {
    return false;
  }
  contact.separation = locus.z - rail.z;
  contact.slope = rail.dz / rail.dy;
  slope_difference = wheel.dz / wheel.dy - contact.slope;
  const double stretch = 1 + contact.slope * contact.slope;
  contact.curvature =
      (wheel_point.curvature() - rail_->profile().at(contact.rail_u).curvature()) * stretch * std::sqrt(stretch);
  return std::isfinite(contact.separation) && std::isfinite(slope_difference);
}

InitialContact ContactSearch::refined(std::size_t k) const
{
  InitialContact contact{stationY(k), separation_[k], 0, 0, wheel_outline_.u[k], rail_outline_.u[k]};
  const std::size_t before = k > 0 ? k - 1 : k;
  const std::size_t after = std::min(k + 1, separation_.size() - 1);
  InitialContact trial;
  double low = 0;
  double high = 0;
  const bool bracketed = separation_[before] < infinity && separation_[after] < infinity &&
                         exact(stationY(before), before, trial, low) && exact(stationY(after), after, trial, high) &&
                         low < 0 && high > 0;
  double difference = 0;
  const auto slopeDifference = [&](double y) { return exact(y, k, trial, difference) ? difference : 0.0; };
  const double y = bracketed
                       ? bracketedRoot(slopeDifference, stationY(before), low, stationY(after), high, root_tolerance)
                       : stationY(k);
  if (exact(y, k, trial, difference))
  {
    contact = trial;
  }
  return contact;
}

bool ContactSearch::nearest(InitialContact& contact) const
{
  const std::size_t lowest = lowestStation(0, separation_.size());
  if (!(separation_[lowest] < infinity))
  {
    return false;
  }
  contact = refined(lowest);
  return true;
}

/// Stations `first` to `last` with the stretch's edges between stations, without its contact.
OverlapZone ContactSearch::stretch(std::size_t first, std::size_t last, double separation) const
{
  OverlapZone zone;
  const auto edge = [&](std::size_t inside, std::size_t outside)
  {
    const double share = (separation - separation_[inside]) / (separation_[outside] - separation_[inside]);
    return rail_outline_.u[inside] + share * (rail_outline_.u[outside] - rail_outline_.u[inside]);
  };
  const bool starts_open = first == 0 || !(separation_[first - 1] < infinity);
  const bool ends_open = last + 1 == separation_.size() || !(separation_[last + 1] < infinity);
  zone.at_profile_end = starts_open || ends_open;
  zone.u_begin = starts_open ? rail_outline_.u[first] : edge(first, first - 1);
  zone.u_end = ends_open ? rail_outline_.u[last] : edge(last, last + 1);
  return zone;
}

/// Measures a stretch narrower than the stations can tell by its osculating parabola. False if it vanishes.
bool ContactSearch::narrow(double separation, OverlapZone& zone)
{
  const InitialContact& contact = zone.contact;
  const double depth = separation - contact.separation;
  if (!(depth > 0))
  {
    return false;
  }
  const double half = contact.curvature > 0 ? std::sqrt(2 * depth / contact.curvature) : infinity;
  if (half < static_cast<double>(fine_stations) * spacing)
  {
    const double along_rail = half * std::sqrt(1 + contact.slope * contact.slope);
    zone.u_begin = contact.rail_u - along_rail;
    zone.u_end = contact.rail_u + along_rail;
  }
  return zone.u_end > zone.u_begin;
}

std::size_t ContactSearch::lowestStation(std::size_t first, std::size_t behind) const
{
  const auto begin = separation_.begin();
  return static_cast<std::size_t>(
      std::min_element(begin + static_cast<long>(first), begin + static_cast<long>(behind)) - begin);
}

OverlapZone ContactSearch::zoneAround(const InitialContact& contact, double separation) const
{
  const auto last_station = static_cast<double>(separation_.size() - 1);
  const auto k = static_cast<std::size_t>(std::clamp(std::round((contact.y - y_first_) / spacing), 0.0, last_station));
  std::size_t first = k;
  std::size_t last = k;
  while (first > 0 && separation_[first - 1] < separation)
  {
    --first;
  }
  while (last + 1 < separation_.size() && separation_[last + 1] < separation)
  {
    ++last;
  }
  OverlapZone zone = separation_[k] < separation ? stretch(first, last, separation) : OverlapZone{};
  zone.contact = contact;
  if (last - first + 1 < fine_stations)
  {
    narrow(separation, zone);
  }
  return zone;
}

void ContactSearch::overlapZones(double separation, std::vector<OverlapZone>& zones) const
{
  zones.clear();
  for (std::size_t k = 0; k < separation_.size(); ++k)
  {
    const std::size_t first = k;
    while (k < separation_.size() && separation_[k] < separation)
    {
      ++k;
    }
    const bool minimum = k == first && isMinimum(k) && separation_[k] < separation + station_error;
    if (k == first && !minimum)
    {
      continue;
    }
    OverlapZone zone = minimum ? OverlapZone{} : stretch(first, k - 1, separation);
    zone.contact = refined(minimum ? k : lowestStation(first, k));
    if (k - first >= fine_stations || narrow(separation, zone))
    {
      zones.push_back(zone);
    }
  }
  mergeNeighbours(zones);
}

void ContactSearch::stationsBetween(double u_begin, double u_end, std::vector<Station>& stations) const
{
  stations.clear();
  for (std::size_t k = 0; k < separation_.size(); ++k)
  {
    const double u = rail_outline_.u[k];
    if (u > u_begin && u < u_end && separation_[k] < infinity)
    {
      stations.push_back({u, separation_[k]});
    }
  }
}

void ContactSearch::mergeNeighbours(std::vector<OverlapZone>& zones) const
{
  for (std::size_t i = 1; i < zones.size();)
  {
    OverlapZone& before = zones[i - 1];
    const OverlapZone& here = zones[i];
    const double wider = std::max(before.u_end - before.u_begin, here.u_end - here.u_begin);
    const double turn = std::abs(std::atan(here.contact.slope) - std::atan(before.contact.slope));
    if (here.u_begin - before.u_end > wider || turn > merge_angle)
    {
      ++i;
      continue;
    }
    before.u_end = here.u_end;
    before.at_profile_end = before.at_profile_end || here.at_profile_end;
    if (here.contact.separation < before.contact.separation)
    {
      before.contact = here.contact;
    }
    zones.erase(zones.begin() + static_cast<long>(i));
  }
}
}  // namespace wheel_rail_contact
