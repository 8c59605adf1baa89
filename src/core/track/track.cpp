// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/track.h"

#include <algorithm>
#include <cmath>

#include "core/option_check.h"
#include "core/profile/curve/monotone_cubic.h"

namespace wheel_rail_contact::core
{
namespace
{
// Far wider than on real tracks and wheelsets, but without a usual length in millimetres.
constexpr LengthRange gauges{0.2, 3};  ///< and flange back distances
constexpr LengthRange gauge_depths{1e-5, 0.1};
constexpr LengthRange rolling_radii{0.05, 2};
constexpr LengthRange tape_circles{0.005, 0.5};

constexpr double largest_value = 0.2;  ///< of a cross level or displacement [m], [rad]

/// True if the values of a station are finite and not above 0.2 m or 0.2 rad.
bool isPlausible(const LineStation& station)
{
  const auto valid = [](double value) { return std::abs(value) <= largest_value; };
  const auto placed = [&valid](const RailDeflection& rail)
  { return valid(rail.lateral) && valid(rail.vertical) && valid(rail.roll); };
  return valid(station.cross_level) && placed(station.rail.left) && placed(station.rail.right);
}
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
  return {station.cross_level, left.lateral, left.vertical, left.roll, right.lateral, right.vertical, right.roll};
}

TrackLine::TrackLine(std::string name, const std::vector<LineStation>& stations, double longest_gap)
    : name_(std::move(name)), longest_gap_(longest_gap)
{
  refuseIf(stations.size() < 2, name_ + ": a line needs at least two stations");
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    x_.push_back(stations[i].x);
    values_.push_back(quantitiesOf(stations[i]));
    const bool increases = std::isfinite(x_[i]) && (i == 0 || x_[i] > x_[i - 1]);
    refuseIf(!increases, name_, ": station ", i + 1, ": x must increase");
    refuseIf(!isPlausible(stations[i]), name_, ": station ", i + 1,
             ": a cross level or displacement is above 0.2 m or 0.2 rad");
  }
  slopes_.resize(x_.size());
  for (std::size_t k = 0; k < quantities; ++k)
  {
    const auto rise = [&](std::size_t i) { return (values_[i + 1][k] - values_[i][k]) / (x_[i + 1] - x_[i]); };
    const std::size_t last = x_.size() - 1;
    slopes_.front()[k] = rise(0);
    slopes_.back()[k] = rise(last - 1);
    for (std::size_t i = 1; i < last; ++i)
    {
      slopes_[i][k] = isGap(i)       ? rise(i)
                      : isGap(i + 1) ? rise(i - 1)
                                     : monotoneSlope(rise(i - 1), rise(i), x_[i] - x_[i - 1], x_[i + 1] - x_[i]);
    }
  }
}

/// Number of the first station after x, at least 1; of the last one if there is none.
std::size_t TrackLine::stationAfter(double x) const
{
  return static_cast<std::size_t>(std::upper_bound(x_.begin() + 1, x_.end() - 1, x) - x_.begin());
}

std::optional<std::array<double, 2>> TrackLine::gapAt(double x) const
{
  const std::size_t i = stationAfter(x);
  const bool is_inside = isGap(i) && x > x_[i - 1] && x < x_[i];
  return is_inside ? std::optional(std::array<double, 2>{x_[i - 1], x_[i]}) : std::nullopt;
}

LineStation TrackLine::at(double x) const
{
  const std::size_t i = stationAfter(x);
  const double t = x - x_[i - 1];
  Quantities q;
  for (std::size_t k = 0; k < quantities; ++k)
  {
    double c[4];
    setCubic(values_[i - 1][k], values_[i][k], slopes_[i - 1][k], slopes_[i][k], x_[i] - x_[i - 1], c);
    q[k] = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
  }
  return {x, q[0], {RailDeflection{q[1], q[2], q[3]}, RailDeflection{q[4], q[5], q[6]}}};
}
}  // namespace wheel_rail_contact::core
