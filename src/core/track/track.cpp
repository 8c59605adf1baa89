// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/track.h"

#include <algorithm>
#include <cmath>

#include "core/option_check.h"
#include "core/profile/curve/monotone_cubic.h"
#include "core/track/line_rows.h"

namespace wheel_rail_contact::core
{
namespace
{
// Far wider than on real tracks and wheelsets, but without a usual length in millimetres.
constexpr LengthRange gauges{0.2, 3};  ///< and flange back distances
constexpr LengthRange gauge_depths{1e-5, 0.1};
constexpr LengthRange rolling_radii{0.05, 2};
constexpr LengthRange tape_circles{0.005, 0.5};

constexpr double joined_within = 1e-6;  ///< values at both ends of a line that repeats [SI units]
}  // namespace

double modelScale(const TrackConfig& track, const WheelsetConfig& wheelset)
{
  constexpr double smallest_vehicle = 0.4;  // a gauge of 600 mm is one
  const double scale =
      std::max(wheelset.meanRadius() / WheelsetConfig().meanRadius(), track.gauge / TrackConfig().gauge);
  return scale > smallest_vehicle ? 1 : scale;
}

void validate(const TrackConfig& track)
{
  requireLength("track/gauge", track.gauge, gauges);
  requireLength("track/gauge_depth", track.gauge_depth, gauge_depths);
  for (const Side side : sides)
  {
    requireWithin(optionOf(track.rail_inclination, side, "track/rail_inclination", "rail", "inclination"),
                  track.rail_inclination[side], 0.2, "must be within ±0.2 rad");
  }
}

void validate(const WheelsetConfig& wheelset)
{
  for (const Side side : sides)
  {
    requireLength(optionOf(wheelset.rolling_radius, side, "wheelset/rolling_radius", "wheel", "rolling_radius"),
                  wheelset.rolling_radius[side], rolling_radii);
    if (wheelset.out_of_round[side])
    {
      validate(*wheelset.out_of_round[side], wheelset.rolling_radius[side],
               std::string("wheel/") + nameOf(side) + "/out_of_round");
    }
  }
  requireLength("wheelset/flange_back_distance", wheelset.flange_back_distance, gauges);
  requireLength("wheelset/tape_circle", wheelset.tape_circle, tape_circles);
}

TrackLine::Quantities TrackLine::quantitiesOf(const LineStation& station)
{
  const RailDeflection &left = station.rail.left, &right = station.rail.right;
  const TrackDesign& design = station.design;
  return {station.cross_level, left.lateral, left.vertical,    left.roll,   right.lateral,
          right.vertical,      right.roll,   design.curvature, design.cant, design.gradient};
}

TrackLine::TrackLine(std::string name, const std::vector<LineStation>& stations, double longest_gap, bool repeats)
    : name_(std::move(name)), longest_gap_(longest_gap), repeats_(repeats)
{
  refuseIf(stations.size() < 2, name_ + ": a line needs at least two stations");
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    x_.push_back(stations[i].x);
    values_.push_back(quantitiesOf(stations[i]));
    const bool increases = std::isfinite(x_[i]) && (i == 0 || x_[i] > x_[i - 1]);
    refuseIf(!increases, name_, ": station ", i + 1, ": x must increase");
    const auto begin = values_[i].begin(), end = values_[i].end(), design = begin + irregularities;
    const auto large = std::find_if(begin, end, [](double value) { return !(std::abs(value) <= largest_line_value); });
    refuseIf(large != end, name_, ": station ", i + 1,
             large < design ? ": a cross level or displacement is above 0.2 m or 0.2 rad"
                            : ": curvature, cant or gradient is above 0.2 1/m, 0.2 rad or 0.2");
  }
  if (repeats_)
  {
    for (std::size_t k = 0; k < quantities; ++k)
    {
      const double step = values_.back()[k] - values_.front()[k];
      refuseIf(std::abs(step) > joined_within, name_, ": repeat: a step of ", step, " in ",
               line_columns[line_quantity::cross_level + k].name, " (SI units) from the last station to the first one");
    }
    values_.back() = values_.front();
  }
  slopes_.resize(x_.size());
  for (std::size_t k = 0; k < irregularities; ++k)
  {
    const auto rise = [&](std::size_t i) { return (values_[i + 1][k] - values_[i][k]) / (x_[i + 1] - x_[i]); };
    const std::size_t last = x_.size() - 1;
    const auto slope = [&](std::size_t before, std::size_t after)  // intervals, by the station at their end
    {
      return isGap(before)  ? rise(after - 1)
             : isGap(after) ? rise(before - 1)
                            : monotoneSlope(rise(before - 1), rise(after - 1), x_[before] - x_[before - 1],
                                            x_[after] - x_[after - 1]);
    };
    slopes_.front()[k] = repeats_ ? slope(last, 1) : rise(0);
    slopes_.back()[k] = repeats_ ? slope(last, 1) : rise(last - 1);
    for (std::size_t i = 1; i < last; ++i)
    {
      slopes_[i][k] = slope(i, i + 1);
    }
  }
}

/// The place of the first repetition that is as x [m].
double TrackLine::withinStations(double x) const
{
  const double length = x_.back() - x_.front();
  const auto first = [&]
  { return std::clamp(x - std::floor((x - x_.front()) / length) * length, x_.front(), x_.back()); };
  return repeats_ ? first() : x;
}

/// Number of the first station after x, at least 1; of the last one if there is none.
std::size_t TrackLine::stationAfter(double x) const
{
  return static_cast<std::size_t>(std::upper_bound(x_.begin() + 1, x_.end() - 1, x) - x_.begin());
}

std::optional<std::array<double, 2>> TrackLine::gapAt(double x) const
{
  const double place = withinStations(x), moved = x - place;
  const std::size_t i = stationAfter(place);
  const bool is_inside = isGap(i) && place > x_[i - 1] && place < x_[i];
  return is_inside ? std::optional(std::array<double, 2>{x_[i - 1] + moved, x_[i] + moved}) : std::nullopt;
}

LineStation TrackLine::at(double x) const
{
  const double place = withinStations(x);
  const std::size_t i = stationAfter(place);
  const double t = place - x_[i - 1];
  std::array<double, irregularities> q;
  for (std::size_t k = 0; k < irregularities; ++k)
  {
    double c[4];
    setCubic(values_[i - 1][k], values_[i][k], slopes_[i - 1][k], slopes_[i][k], x_[i] - x_[i - 1], c);
    q[k] = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
  }
  return {x, q[0], {RailDeflection{q[1], q[2], q[3]}, RailDeflection{q[4], q[5], q[6]}}, designIn(i, place)};
}

bool TrackLine::hasDesign() const
{
  return std::any_of(values_.begin(), values_.end(),
                     [](const Quantities& q)
                     { return std::any_of(q.begin() + irregularities, q.end(), [](double v) { return v != 0; }); });
}

TrackDesign TrackLine::designAt(double x, TrackDesign* change) const
{
  const double place = std::clamp(withinStations(x), x_.front(), x_.back());
  return designIn(stationAfter(place), place, change);
}

/// Design at a place [m] before the station i, and its change per metre.
TrackDesign TrackLine::designIn(std::size_t i, double place, TrackDesign* change) const
{
  const auto &from = values_[i - 1], &to = values_[i];
  const auto rate = [&](std::size_t k)
  { return (to[irregularities + k] - from[irregularities + k]) / (x_[i] - x_[i - 1]); };
  const auto value = [&](std::size_t k) { return from[irregularities + k] + (place - x_[i - 1]) * rate(k); };
  if (change != nullptr)
  {
    *change = {rate(0), rate(1), rate(2)};
  }
  return {value(0), value(1), value(2)};
}
}  // namespace wheel_rail_contact::core
