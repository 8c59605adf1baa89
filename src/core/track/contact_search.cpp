// SPDX-License-Identifier: BSD-3-Clause
// ContactSearch: outlines, stations and overlap intervals. exact_contact.cpp refines single contacts.
#include "core/track/contact_search.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
constexpr std::size_t most_parts = 16;     ///< of a rail for which memory is taken
constexpr std::size_t along_stations = 4;  ///< from one shape along the track to the next
constexpr std::size_t fine_stations = 8;   ///< intervals of fewer stations: their width follows from the curvature

/// Adds parameters of equidistant points of a part of a profile, about `spacing` apart, including both ends.
void ContactSearch::sample(const ParameterRange& part, std::vector<double>& u)
{
  const double length = part.end - part.begin;
  const long count = std::max(2L, std::lround(length / spacing) + 1);
  for (long i = 0; i < count; ++i)
  {
    u.push_back(part.begin + length * static_cast<double>(i) / static_cast<double>(count - 1));
  }
}

ContactSearch::ContactSearch(const Profile& wheel, const Profile& rail, double longest_rail, const SearchScope& scope)
    : scope_(scope)
{
  // The width of a rail never exceeds the length of its profile: memory for any position of the rail.
  const double longest = std::max(longest_rail, rail.length());
  const Stations room{0, spacing, static_cast<std::size_t>(longest / spacing) + 2};
  wheel_outline_.start(room);
  rail_outline_.start(room);
  separation_.reserve(room.count);
  minima_.reserve(room.count);
  for (std::vector<double>* of_rail : {&rail_line_.u, &rail_line_.y, &rail_line_.z})
  {
    of_rail->reserve(room.count + most_parts);
  }
  rail_points_.reserve(room.count + most_parts);
  along_.reserve(room.count / along_stations + 2);
  rail_outline_.reserve(room.count + most_parts);
  part_ends_.reserve(most_parts);
  sampleRail(rail);
  sample({0, std::min(wheel.length(), scope.wheel_end)}, wheel_line_.u);
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
}

void ContactSearch::sampleRail(const Profile& rail)
{
  rail_line_.u.clear();
  part_ends_.clear();
  for (std::size_t part = scope_.first_part; part < rail.parts().size(); ++part)
  {
    sample(rail.parts()[part], rail_line_.u);
    part_ends_.push_back(rail_line_.u.size());
  }
  rail_points_.clear();
  ProfileCursor cursor(rail);
  for (const double u : rail_line_.u)
  {
    rail_points_.push_back(cursor.at(u));
  }
}

void ContactSearch::setRail(const PlacedRail& rail, bool reshaped)
{
  if (reshaped)
  {
    sampleRail(rail.profile());
  }
  rail_ = rail;
  rail_line_.y.clear();
  rail_line_.z.clear();
  for (const CurvePoint& point : rail_points_)
  {
    const PlanePoint place = turned(rail.place(point));
    rail_line_.y.push_back(place.y);
    rail_line_.z.push_back(place.z);
  }
  const auto [low, high] = std::minmax_element(rail_line_.y.begin(), rail_line_.y.end());
  minima_.clear();
  nearest_station_ = no_station;
  stations_ = {*low, spacing, static_cast<std::size_t>((*high - *low) / spacing) + 2};
  rail_outline_.start(stations_);
  std::size_t first = 0;
  for (const std::size_t end : part_ends_)
  {
    rail_outline_.add(rail_line_, first, end);
    first = end;
  }
  separation_.resize(stations_.count);
  along_.clear();
  for (std::size_t k = 0; rail.changes() && k < stations_.count + along_stations; k += along_stations)
  {
    const std::size_t last = std::min(k, stations_.count - 1);
    const bool is_on_rail = rail_outline_.z(last) > -infinity;
    const AlongShape beside = along_.empty() ? AlongShape() : along_.back();  // beside an edge, as on the edge
    along_.push_back(is_on_rail ? alongAt(rail_outline_.u(last)) : beside);
  }
}

/// Lowers points of the wheel by the lift of the rail beneath them: the rail is then a prism for the search.
void ContactSearch::lowerWheel(std::size_t first, std::size_t end)
{
  constexpr double per_spacing = 1 / (spacing * along_stations);
  for (std::size_t i = first; i < end; ++i)
  {
    const double place = (wheel_line_.y[i] - stations_.first) * per_spacing;
    if (place >= 0 && place < static_cast<double>(along_.size() - 1))
    {
      const auto before = static_cast<std::size_t>(place);
      const double share = place - static_cast<double>(before);
      const AlongShape &one = along_[before], &other = along_[before + 1];
      const AlongShape between{one.slope + share * (other.slope - one.slope),
                               one.curvature + share * (other.curvature - one.curvature)};
      const CurvePoint point{wheel_points_.y[i], wheel_points_.z[i], 1, wheel_points_.slope[i], 0, 0};
      wheel_line_.z[i] -= touchOf(between, point, wheel_->locusX(point)).lift;
    }
  }
}

/// Range of the wheel points that can be above the rail, in whole groups: first point, and end (exclusive).
std::pair<std::size_t, std::size_t> ContactSearch::pointsOverRail(const PlacedWheel& wheel) const
{
  const double least = stations_.first - wheel.lateralBound();
  const double most = stations_.y(stations_.count - 1) + wheel.lateralBound();
  const auto beside = [&](std::size_t group)
  { return wheel.across(group_end_[group]) < least || wheel.across(group_begin_[group]) > most; };
  std::size_t first = 0;
  std::size_t end = group_begin_.size();
  while (first < end && beside(first))
  {
    ++first;
  }
  while (first < end && beside(end - 1))
  {
    --end;
  }
  const std::size_t with_next = std::min(end + 1, group_begin_.size());
  return {first * WheelPoints::together, with_next * WheelPoints::together};
}

void ContactSearch::setWheel(const PlacedWheel& wheel)
{
  wheel_ = wheel;
  wheel_outline_.start(stations_);
  const auto [first, end] =
      scope_.axes.areTurned() ? std::make_pair(std::size_t{0}, wheel_points_.y.size()) : pointsOverRail(wheel);
  wheel.loci(wheel_points_, first, end, wheel_line_.y.data(), wheel_line_.z.data());
  for (std::size_t i = first; scope_.axes.areTurned() && i < end; ++i)
  {
    scope_.axes.turn(wheel_line_.y[i], wheel_line_.z[i]);
  }
  if (!along_.empty())
  {
    lowerWheel(first, end);
  }
  wheel_outline_.add(wheel_line_, first, end);
  wheel_outline_.above(rail_outline_, separation_);
  findMinima();
  nearest_station_ = no_station;
}

/// Finds the minima of each part of the rail.
void ContactSearch::findMinima()
{
  minima_.clear();
  const std::size_t last = separation_.size() - 1;
  std::size_t first = 0;
  for (std::size_t k = 0; part_ends_.size() > 1 && k < last; ++k)
  {
    if (!areOnePart(k, k + 1))
    {
      findMinima(first, k);
      first = k + 1;
    }
  }
  findMinima(first, last);
}

/// Finds the minima of the stations `first` to `last`.
void ContactSearch::findMinima(std::size_t first, std::size_t last)
{
  const double* separation = separation_.data();
  for (std::size_t k = first; k <= last; ++k)
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

/// Upper bound of the depth of a minimum below its lowest station [m]: twice that of the parabola through three
/// stations, plus the error of straight segments on a steep flank.
double ContactSearch::depthBelowStation(std::size_t k) const
{
  const auto [before, after] = neighbours(k);
  if (before == k || after == k)
  {
    return infinity;
  }
  return 0.25 * (separation_[k - 1] - 2 * separation_[k] + separation_[k + 1]) + 4 * station_error;
}

/// Sets the ends of the interval of the stations `first` to `last`, interpolated between stations.
void ContactSearch::setEnds(std::size_t first, std::size_t last, double separation, OverlapInterval& interval) const
{
  const auto edge = [&](std::size_t inside, std::size_t outside)
  {
    const double share = (separation - separation_[inside]) / (separation_[outside] - separation_[inside]);
    return rail_outline_.u(inside) + share * (rail_outline_.u(outside) - rail_outline_.u(inside));
  };
  const std::size_t before = neighbours(first).first, after = neighbours(last).second;
  const bool has_begin = before < first && separation_[before] < infinity;
  const bool has_end = after > last && separation_[after] < infinity;
  interval.u_begin = has_begin ? edge(first, before) : rail_outline_.u(first);
  interval.u_end = has_end ? edge(last, after) : rail_outline_.u(last);
}

/// Widens an interval that the stations do not resolve to that of the osculating parabola of its separation.
/// @return false if the interval is empty.
bool ContactSearch::widenByCurvature(double separation, OverlapInterval& interval)
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
    interval.u_begin = std::min(interval.u_begin, contact.rail_u - along_rail);
    interval.u_end = std::max(interval.u_end, contact.rail_u + along_rail);
  }
  return interval.u_end > interval.u_begin;
}

/// True if the rail outline shows the same part at both stations.
bool ContactSearch::areOnePart(std::size_t k, std::size_t other) const
{
  return part_ends_.size() == 1 || std::abs(rail_outline_.u(k) - rail_outline_.u(other)) < 0.5 * Profile::part_distance;
}

/// Neighbours of a station on the same part; the station itself where there is none.
std::pair<std::size_t, std::size_t> ContactSearch::neighbours(std::size_t k) const
{
  const bool has_before = k > 0 && areOnePart(k - 1, k);
  const bool has_after = k + 1 < separation_.size() && areOnePart(k, k + 1);
  return {has_before ? k - 1 : k, has_after ? k + 1 : k};
}

/// First and last station of the uninterrupted series of stations below `separation` around station k. Station k
/// belongs to it in any case.
std::pair<std::size_t, std::size_t> ContactSearch::belowAround(std::size_t k, double separation) const
{
  std::size_t first = k, last = k;
  while (first > 0 && separation_[first - 1] < separation && areOnePart(first - 1, first))
  {
    --first;
  }
  while (last + 1 < separation_.size() && separation_[last + 1] < separation && areOnePart(last, last + 1))
  {
    ++last;
  }
  return {first, last};
}

void ContactSearch::overlapIntervals(double separation, std::vector<OverlapInterval>& intervals) const
{
  intervals.clear();
  std::size_t end = 0;  // of the stations already processed
  for (const std::size_t minimum : minima_)
  {
    if (minimum < end)
    {
      continue;
    }
    OverlapInterval interval;
    if (separation_[minimum] < separation)
    {
      const auto [first, last] = belowAround(minimum, separation);
      end = last + 1;
      setEnds(first, last, separation, interval);
      const auto begin = separation_.begin();
      const auto lowest = std::min_element(begin + static_cast<long>(first), begin + static_cast<long>(end));
      interval.contact = refined(static_cast<std::size_t>(lowest - begin));
      const auto next = std::upper_bound(minima_.begin(), minima_.end(), minimum);
      interval.has_one_minimum = next == minima_.end() || *next >= end;
      if (end - first >= fine_stations)
      {
        intervals.push_back(interval);
        continue;
      }
    }
    else if (separation_[minimum] < separation + depthBelowStation(minimum))
    {
      interval.contact = refined(minimum);
      interval.u_begin = interval.u_end = interval.contact.rail_u;
    }
    else
    {
      continue;
    }
    if (widenByCurvature(separation, interval))
    {
      intervals.push_back(interval);
    }
  }
  if (part_ends_.size() > 1)
  {
    std::sort(intervals.begin(), intervals.end(),
              [](const OverlapInterval& a, const OverlapInterval& b) { return a.contact.rail_u < b.contact.rail_u; });
  }
}

std::size_t ContactSearch::nearestStation(double y) const
{
  const double station = (y - stations_.first) / spacing;
  return static_cast<std::size_t>(std::clamp(station + 0.5, 0.0, static_cast<double>(stations_.count - 1)));
}

void ContactSearch::stationsOf(const OverlapInterval& interval, const std::vector<std::pair<double, double>>& known,
                               std::vector<OverlapStation>& stations) const
{
  stations.clear();
  const auto [first, last] = belowAround(nearestStation(interval.contact.y), 0);
  bool was_inside = false;
  for (std::size_t k = first; k <= last; ++k)
  {
    const double u = rail_outline_.u(k);
    const bool is_inside = std::any_of(known.begin(), known.end(),
                                       [u](const auto& range) { return u >= range.first && u <= range.second; });
    if (!is_inside || !was_inside)
    {
      const auto [before, after] = neighbours(k);
      const double slope = after > before ? (rail_outline_.z(after) - rail_outline_.z(before)) /
                                                (stations_.y(after) - stations_.y(before))
                                          : 0;
      stations.push_back({u, stations_.y(k), rail_outline_.z(k), -separation_[k] / std::sqrt(1 + slope * slope)});
    }
    was_inside = is_inside;
  }
}

void ContactSearch::moveEnds(double separation, OverlapInterval& interval) const
{
  const std::size_t nearest = nearestStation(interval.contact.y);
  interval.u_begin = interval.u_end = interval.contact.rail_u;
  if (separation_[nearest] < separation)
  {
    const auto [first, last] = belowAround(nearest, separation);
    setEnds(first, last, separation, interval);
    if (last + 1 - first >= fine_stations)
    {
      return;
    }
  }
  widenByCurvature(separation, interval);
}
}  // namespace wheel_rail_contact::core
