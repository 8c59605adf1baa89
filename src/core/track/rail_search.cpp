// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/rail_search.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
namespace
{
const double half = std::sqrt(0.5);
const double steep_slope = -std::sqrt(3.0);  ///< dz/dy of a surface that faces the field side at 60°
constexpr double least_rise = 0.01;          ///< of a normal [-]: a steeper contact is taken as this steep
constexpr std::size_t usual_intervals = 8;
constexpr double tip_spacing = 1e-4;  ///< of the places at which the flange tip is searched for [m]

/// Parameter of the lowest point of a wheel profile [m].
double flangeTip(const Profile& wheel)
{
  double tip = 0;
  for (double u = 0; u < wheel.length(); u += tip_spacing)
  {
    tip = wheel.at(u).z < wheel.at(tip).z ? u : tip;
  }
  return tip;
}
}  // namespace

RailSearch::RailSearch(const Profile& wheel, const Profile& rail, double longest_rail, bool several_parts)
    : from_above_(wheel, rail, longest_rail)
{
  if (several_parts)
  {
    turned_.emplace(wheel, rail, longest_rail, SearchScope{{half, -half}, flangeTip(wheel), 1});
    steep_.reserve(usual_intervals);
  }
}

bool RailSearch::isSteep(const InitialContact& contact)
{
  return contact.slope < steep_slope;
}

void RailSearch::setRail(const PlacedRail& rail, bool reshaped)
{
  rail_ = rail;
  from_above_.setRail(rail, reshaped);
  uses_turned_ = turned_ && rail.profile().parts().size() > 1;
  if (uses_turned_)
  {
    turned_->setRail(rail, reshaped);
  }
}

void RailSearch::setWheel(const PlacedWheel& wheel)
{
  from_above_.setWheel(wheel);
  if (uses_turned_)
  {
    turned_->setWheel(wheel);
  }
}

/// A contact of the second search in side axes: its separation becomes that along z with the same distance along the
/// normal.
InitialContact RailSearch::inSideAxes(const InitialContact& seen) const
{
  const PlanePoint point = rail_->at(seen.rail_u);
  const double per_length = 1 / std::hypot(point.dy, point.dz);
  const double normal_y = -point.dz * per_length, normal_z = point.dy * per_length;
  InitialContact contact = seen;
  contact.y = point.y;
  contact.slope = -normal_y / std::max(normal_z, least_rise);
  contact.separation = seen.separation * half * (normal_y + normal_z) / std::max(normal_z, least_rise);
  return contact;
}

bool RailSearch::nearest(InitialContact& contact)
{
  const bool found = from_above_.nearest(contact);
  InitialContact seen;
  if (!uses_turned_ || !turned_->nearest(seen))
  {
    return found;
  }
  const InitialContact steep = inSideAxes(seen);
  if (isSteep(steep) && (!found || steep.separation < contact.separation))
  {
    contact = steep;
    return true;
  }
  return found;
}

void RailSearch::overlapIntervals(double separation, std::vector<OverlapInterval>& intervals)
{
  from_above_.overlapIntervals(separation, intervals);
  if (!uses_turned_)
  {
    return;
  }
  turned_->overlapIntervals(0, steep_);
  for (OverlapInterval& interval : steep_)
  {
    interval.seen = interval.contact;
    interval.contact = inSideAxes(interval.contact);
  }
  // In these axes the flange tip is below the gauge corner of a part, too.
  const auto is_flat = [](const OverlapInterval& one) { return !isSteep(one.contact); };
  steep_.erase(std::remove_if(steep_.begin(), steep_.end(), is_flat), steep_.end());
  const auto cover = [](const OverlapInterval& one, const OverlapInterval& other)
  { return one.u_begin < other.u_end && other.u_begin < one.u_end; };
  const auto is_replaced = [&](const OverlapInterval& own)
  {
    return isSteep(own.contact) &&
           std::any_of(steep_.begin(), steep_.end(), [&](const OverlapInterval& one) { return cover(own, one); });
  };
  intervals.erase(std::remove_if(intervals.begin(), intervals.end(), is_replaced), intervals.end());
  const std::size_t own = intervals.size();
  for (const OverlapInterval& interval : steep_)
  {
    const auto end = intervals.begin() + static_cast<long>(own);
    if (std::none_of(intervals.begin(), end, [&](const OverlapInterval& one) { return cover(one, interval); }))
    {
      intervals.push_back(interval);
    }
  }
  std::sort(intervals.begin(), intervals.end(),
            [](const OverlapInterval& one, const OverlapInterval& other) { return one.u_begin < other.u_begin; });
}

void RailSearch::stationsOf(const OverlapInterval& interval, const std::vector<std::pair<double, double>>& known,
                            std::vector<OverlapStation>& stations) const
{
  if (!interval.seen)
  {
    from_above_.stationsOf(interval, known, stations);
    return;
  }
  OverlapInterval own = interval;
  own.contact = *interval.seen;
  turned_->stationsOf(own, known, stations);
  for (OverlapStation& station : stations)
  {
    const PlanePoint point = rail_->at(station.rail_u);
    station.y = point.y;
    station.z = point.z;
  }
}

void RailSearch::moveEnds(double separation, OverlapInterval& interval) const
{
  if (!interval.seen)
  {
    from_above_.moveEnds(separation, interval);
    return;
  }
  OverlapInterval own = interval;
  own.contact = *interval.seen;
  turned_->moveEnds(separation * interval.seen->separation / interval.contact.separation, own);
  interval.u_begin = own.u_begin;
  interval.u_end = own.u_end;
}
}  // namespace wheel_rail_contact::core
