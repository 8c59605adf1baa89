// SPDX-License-Identifier: BSD-3-Clause
// Outlines, stations and stretches; single contacts are made exact in exact_contact.cpp.
#include "core/track/contact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t fine_stations = 8;  ///< stretches of fewer stations are measured by their curvature

}  // namespace

/// Parameters of points of a profile about `spacing` apart.
std::vector<double> ContactSearch::sample(const Profile& profile)
{
  const long count = std::max(2L, std::lround(profile.length() / spacing) + 1);
  std::vector<double> u(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < u.size(); ++i)
  {
    u[i] = profile.length() * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  return u;
}

ContactSearch::ContactSearch(const Profile& wheel, const Profile& rail)
{
  rail_line_.u = sample(rail);
  for (const double u : rail_line_.u)
  {
    rail_points_.push_back(rail.at(u));
  }
  wheel_line_.u = sample(wheel);
  while (wheel_line_.u.size() % WheelPoints::together != 0)
  {
    wheel_line_.u.push_back(wheel_line_.u.back());
  }
  for (const double u : wheel_line_.u)
  {
    const CurvePoint point = wheel.at(u);
    wheel_points_.y.push_back(point.y);
    wheel_points_.z.push_back(point.z);
    wheel_points_.slope.push_back(point.slope());
  }
  wheel_line_.y.resize(wheel_line_.u.size());
  wheel_line_.z.resize(wheel_line_.u.size());
  for (std::size_t i = 0; i < wheel_points_.y.size(); i += WheelPoints::together)
  {
    const auto begin = wheel_points_.y.begin() + static_cast<long>(i);
    const auto end = begin + static_cast<long>(std::min(WheelPoints::together + 1, wheel_points_.y.size() - i));
    const auto [least, most] = std::minmax_element(begin, end);
    group_begin_.push_back(*least);
    group_end_.push_back(*most);
  }
  // A rail is never wider than its profile is long: room for any place of it.
  const Stations most{0, spacing, static_cast<std::size_t>(rail.length() / spacing) + 2};
  wheel_outline_.start(most);
  rail_outline_.start(most);
  separation_.reserve(most.count);
  minima_.reserve(most.count);
}

void ContactSearch::setRail(const PlacedRail& rail)
{
  rail_ = rail;
  rail_line_.y.clear();
  rail_line_.z.clear();
  for (const CurvePoint& point : rail_points_)
  {
    const PlanePoint place = rail.place(point);
    rail_line_.y.push_back(place.y);
    rail_line_.z.push_back(place.z);
  }
  const auto [low, high] = std::minmax_element(rail_line_.y.begin(), rail_line_.y.end());
  minima_.clear();
  nearest_station_ = no_station;
  stations_ = {*low, spacing, static_cast<std::size_t>((*high - *low) / spacing) + 2};
  rail_outline_.start(stations_);
  rail_outline_.add(rail_line_, 0, rail_line_.y.size());
  separation_.resize(stations_.count);
}

/// The first of the wheel's points that may lie over the rail, and the one behind the last, in whole groups.
std::pair<std::size_t, std::size_t> ContactSearch::pointsOverRail(const PlacedWheel& wheel) const
{
  const double least = stations_.first - wheel.lateralBound();
  const double most = stations_.y(stations_.count - 1) + wheel.lateralBound();
  const auto beside = [&](std::size_t group)
  { return wheel.across(group_end_[group]) < least || wheel.across(group_begin_[group]) > most; };
  std::size_t first = 0;
  std::size_t behind = group_begin_.size();
  while (first < behind && beside(first))
  {
    ++first;
  }
  while (first < behind && beside(behind - 1))
  {
    --behind;
  }
  const std::size_t with_next = std::min(behind + 1, group_begin_.size());
  return {first * WheelPoints::together, with_next * WheelPoints::together};
}

void ContactSearch::setWheel(const PlacedWheel& wheel)
{
  wheel_ = wheel;
  wheel_outline_.start(stations_);
  const auto [first, behind] = pointsOverRail(wheel);
  wheel.loci(wheel_points_, first, behind, wheel_line_.y.data(), wheel_line_.z.data());
  wheel_outline_.add(wheel_line_, first, behind);
  wheel_outline_.above(rail_outline_, separation_);
  findMinima();
  nearest_station_ = no_station;
}

void ContactSearch::findMinima()
{
  minima_.clear();
  const double* separation = separation_.data();
  const std::size_t last = separation_.size() - 1;
  for (std::size_t k = 0; k <= last; ++k)
  {
    while (k < last && !(separation[k] < separation[k + 1]))
    {
      ++k;
    }
    if (separation[k] < infinity)
    {
      minima_.push_back(k);
    }
    while (k < last && separation[k] < separation[k + 1])
    {
      ++k;
    }
  }
}

/// How far a minimum may lie below the lowest of its stations [m]: by the parabola through three stations, doubled, and
/// the error of straight segments on a steep flank.
double ContactSearch::depthBelowStation(std::size_t k) const
{
  if (k == 0 || k + 1 >= stations_.count)
  {
    return infinity;
  }
  return 0.25 * (separation_[k - 1] - 2 * separation_[k] + separation_[k + 1]) + 4 * station_error;
}

/// Stations `first` to `last` with the stretch's edges between stations, without its contact.
OverlapInterval ContactSearch::intervalBetween(std::size_t first, std::size_t last, double separation) const
{
  OverlapInterval interval;
  const auto edge = [&](std::size_t inside, std::size_t outside)
  {
    const double share = (separation - separation_[inside]) / (separation_[outside] - separation_[inside]);
    return rail_outline_.u(inside) + share * (rail_outline_.u(outside) - rail_outline_.u(inside));
  };
  const bool starts_open = first == 0 || !(separation_[first - 1] < infinity);
  const bool ends_open = last + 1 == separation_.size() || !(separation_[last + 1] < infinity);
  interval.at_profile_end = starts_open || ends_open;
  interval.u_begin = starts_open ? rail_outline_.u(first) : edge(first, first - 1);
  interval.u_end = ends_open ? rail_outline_.u(last) : edge(last, last + 1);
  return interval;
}

/// Measures a stretch narrower than the stations can tell by its osculating parabola. False if it vanishes.
bool ContactSearch::narrow(double separation, OverlapInterval& interval)
{
  const InitialContact& contact = interval.contact;
  const double depth = separation - contact.separation;
  if (!(depth > 0))
  {
    return false;
  }
  const double half = contact.curvature > 0 ? std::sqrt(2 * depth / contact.curvature) : infinity;
  if (half < static_cast<double>(fine_stations) * spacing)
  {
    const double along_rail = half * std::sqrt(1 + contact.slope * contact.slope);
    interval.u_begin = contact.rail_u - along_rail;
    interval.u_end = contact.rail_u + along_rail;
  }
  return interval.u_end > interval.u_begin;
}

std::size_t ContactSearch::lowestStation(std::size_t first, std::size_t behind) const
{
  const auto begin = separation_.begin();
  return static_cast<std::size_t>(
      std::min_element(begin + static_cast<long>(first), begin + static_cast<long>(behind)) - begin);
}

/// First and last of the stations below `separation` that follow on a station without a gap; that one counts.
std::pair<std::size_t, std::size_t> ContactSearch::belowAround(std::size_t k, double separation) const
{
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
  return {first, last};
}

OverlapInterval ContactSearch::intervalAround(const InitialContact& contact, double separation) const
{
  const auto last_station = static_cast<double>(stations_.count - 1);
  const double place = std::round((contact.y - stations_.first) / stations_.spacing);
  const auto k = static_cast<std::size_t>(std::clamp(place, 0.0, last_station));
  const auto [first, last] = belowAround(k, separation);
  OverlapInterval interval = separation_[k] < separation ? intervalBetween(first, last, separation) : OverlapInterval{};
  interval.contact = contact;
  if (last - first + 1 < fine_stations)
  {
    narrow(separation, interval);
  }
  return interval;
}

double ContactSearch::railAngle(std::size_t k) const
{
  const PlanePoint rail = rail_->at(rail_outline_.u(k));
  return std::atan2(rail.dz, rail.dy);
}

/// Of the outline, from the stations beside; of the profile where the outline breaks off there.
double ContactSearch::railSlope(std::size_t k) const
{
  const std::size_t before = k > 0 ? k - 1 : k;
  const std::size_t after = std::min(k + 1, stations_.count - 1);
  const double slope = (rail_outline_.z(after) - rail_outline_.z(before)) / (stations_.y(after) - stations_.y(before));
  return std::isfinite(slope) ? slope : std::tan(railAngle(k));
}

/// Adds the stretch of stations `first` to `last`, divided where it bends too much for one plane.
void ContactSearch::addIntervals(std::size_t first, std::size_t last, double separation,
                                 std::vector<OverlapInterval>& intervals) const
{
  const std::size_t lowest = lowestStation(first, last + 1);
  for (auto minimum = std::upper_bound(minima_.begin(), minima_.end(), first);
       minimum != minima_.end() && *minimum < last; ++minimum)
  {
    const std::size_t k = *minimum;
    if (k != lowest && std::abs(railAngle(k) - railAngle(lowest)) > split_angle)
    {
      const auto at = [this](std::size_t i) { return separation_.begin() + static_cast<long>(i); };
      const auto divide = static_cast<std::size_t>(std::max_element(at(std::min(k, lowest)), at(std::max(k, lowest))) -
                                                   separation_.begin());
      addIntervals(first, divide, separation, intervals);
      intervals.back().u_most = intervals.back().u_end = rail_outline_.u(divide);
      const std::size_t behind = intervals.size();
      addIntervals(divide, last, separation, intervals);
      intervals[behind].u_least = intervals[behind].u_begin = rail_outline_.u(divide);
      return;
    }
  }
  intervals.push_back(intervalBetween(first, last, separation));
  intervals.back().contact = refined(lowest);
}

void ContactSearch::overlapIntervals(double separation, std::vector<OverlapInterval>& intervals) const
{
  intervals.clear();
  std::size_t behind = 0;  // the last stretch
  for (const std::size_t minimum : minima_)
  {
    if (minimum < behind)
    {
      continue;
    }
    OverlapInterval interval;
    if (separation_[minimum] < separation)
    {
      const auto [first, last] = belowAround(minimum, separation);
      behind = last + 1;
      if (behind - first >= fine_stations)
      {
        addIntervals(first, last, separation, intervals);
        continue;
      }
      interval = intervalBetween(first, last, separation);
      interval.contact = refined(lowestStation(first, behind));
    }
    else if (separation_[minimum] < separation + depthBelowStation(minimum))
    {
      interval.contact = refined(minimum);
    }
    else
    {
      continue;
    }
    if (narrow(separation, interval))
    {
      intervals.push_back(interval);
    }
  }
  mergeNeighbours(intervals);
  keepApart(intervals);
}

/// The first of the stations that the rail's profile passes between two of its parameters, and the one behind the last,
/// or a few more. Where the rail overhangs, its furthest points need not be those at the parameters.
std::pair<std::size_t, std::size_t> ContactSearch::stationsOfRail(double u_begin, double u_end) const
{
  if (!(u_begin < u_end))
  {
    return {0, 0};
  }
  const auto last_point = static_cast<double>(rail_line_.u.size() - 1);
  const double per_point = rail_line_.u.back() / last_point;
  const auto point = [&](double place) { return static_cast<long>(std::clamp(place, 0.0, last_point)); };
  const auto begin = rail_line_.y.begin() + point(std::floor(u_begin / per_point));
  const auto end = rail_line_.y.begin() + point(std::ceil(u_end / per_point)) + 1;
  const auto [least, most] = std::minmax_element(begin, end);
  const auto station = [this](double y) { return static_cast<std::size_t>((y - stations_.first) / stations_.spacing); };
  return {station(*least), std::min(station(*most) + 2, stations_.count)};
}

void ContactSearch::addStationsBetween(double u_begin, double u_end, double separation,
                                       std::vector<Station>& stations) const
{
  const auto [first, behind] = stationsOfRail(u_begin, u_end);
  for (std::size_t k = first; k < behind; ++k)
  {
    const double depth = separation - separation_[k];
    const double u = rail_outline_.u(k);
    if (depth > 0 && u > u_begin && u < u_end)
    {
      stations.push_back({wheel_outline_.u(k), u, stations_.y(k), rail_outline_.z(k), railSlope(k), depth});
    }
  }
}

void ContactSearch::mergeNeighbours(std::vector<OverlapInterval>& intervals) const
{
  for (std::size_t i = 1; i < intervals.size();)
  {
    OverlapInterval& before = intervals[i - 1];
    const OverlapInterval& here = intervals[i];
    const double wider = std::max(before.u_end - before.u_begin, here.u_end - here.u_begin);
    const double turn = std::abs(std::atan(here.contact.slope) - std::atan(before.contact.slope));
    const bool divided = before.u_most == here.u_least;  // halves of a stretch
    if (divided || here.u_begin - before.u_end > wider || turn > merge_angle)
    {
      ++i;
      continue;
    }
    before.u_end = here.u_end;
    before.u_most = here.u_most;
    before.at_profile_end = before.at_profile_end || here.at_profile_end;
    if (here.contact.separation < before.contact.separation)
    {
      before.contact = here.contact;
    }
    intervals.erase(intervals.begin() + static_cast<long>(i));
  }
}

/// Sets where one stretch ends for the other's sake: half-way between neighbours that are not halves of one.
void ContactSearch::keepApart(std::vector<OverlapInterval>& intervals)
{
  for (std::size_t i = 1; i < intervals.size(); ++i)
  {
    OverlapInterval& before = intervals[i - 1];
    OverlapInterval& here = intervals[i];
    if (before.u_most != here.u_least)
    {
      before.u_most = here.u_least = 0.5 * (before.u_end + here.u_begin);
    }
  }
}
}  // namespace wheel_rail_contact::core
