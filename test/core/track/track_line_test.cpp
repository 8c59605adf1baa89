// SPDX-License-Identifier: BSD-3-Clause
#include "../../seeded.h"
#include "../profile/profile_helpers.h"
#include "wheel_rail_contact/core/track.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double line_rounding = 1e-17;  ///< rounding error of sums of lengths below 0.1 m [m]

/// The seven quantities of a station, in the order of LineStation.
std::vector<double> valuesOf(const LineStation& station)
{
  const RailDeflection &left = station.rail.left, &right = station.rail.right;
  return {station.cross_level, left.lateral, left.vertical, left.roll, right.lateral, right.vertical, right.roll};
}

void expectNear(const LineStation& found, const LineStation& expected, double tolerance)
{
  const std::vector<double> values = valuesOf(found), wanted = valuesOf(expected);
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    EXPECT_NEAR(values[k], wanted[k], tolerance) << "x = " << expected.x << ", quantity " << k;
  }
}

/// Station whose quantities are different multiples of `value` [m], [rad].
LineStation stationAt(double x, double value)
{
  return {x, value, {RailDeflection{2 * value, 3 * value, 4 * value}, {5 * value, 6 * value, 7 * value}}};
}

/// Stations `spacing` [m] apart from `begin` to `end` [m], with the values of a function of x.
TrackLine lineThrough(const std::function<double(double)>& function, double begin, double end, double spacing)
{
  std::vector<LineStation> stations;
  const auto count = std::lround((end - begin) / spacing);
  for (long i = 0; i <= count; ++i)
  {
    const double x = begin + static_cast<double>(i) * spacing;
    stations.push_back(stationAt(x, function(x)));
  }
  return {"line", stations};
}

/// Message with which stations are refused; "accepted" if they are not.
std::string refusal(const std::vector<LineStation>& stations)
{
  return refusalOf([&] { TrackLine("line", stations); });
}

class TrackLineTest : public testing::Test
{
 protected:
  TrackLineTest()
  {
    double x = -20;
    for (int i = 0; i < 300; ++i)
    {
      const auto value = [this] { return 0.02 * random_.unit(); };
      LineStation station{x, value(), {RailDeflection{value(), value(), value()}, {value(), value(), value()}}};
      if (i % 7 == 3)
      {
        station.rail.left = stations_.back().rail.left;  // constant over one interval
      }
      stations_.push_back(station);
      x += 0.05 + std::abs(random_.unit());
    }
  }

  Seeded random_{20111U};
  std::vector<LineStation> stations_;  ///< random values at random places
};

TEST_F(TrackLineTest, PassesThroughAllStations)
{
  const TrackLine line("random", stations_);
  EXPECT_EQ(line.name(), "random");
  EXPECT_EQ(line.begin(), stations_.front().x);
  EXPECT_EQ(line.end(), stations_.back().x);
  for (const LineStation& station : stations_)
  {
    const LineStation found = line.at(station.x);
    EXPECT_EQ(found.x, station.x);
    expectNear(found, station, 10 * line_rounding);  // the polynomial is evaluated at its end: rounding of its terms
  }
}

TEST_F(TrackLineTest, NeverLeavesTheRangeOfTheTwoNearestStations)
{
  const TrackLine line("random", stations_);
  constexpr int steps = 50;
  for (std::size_t i = 1; i < stations_.size(); ++i)
  {
    const std::vector<double> before = valuesOf(stations_[i - 1]), after = valuesOf(stations_[i]);
    for (int step = 0; step <= steps; ++step)
    {
      const double x = stations_[i - 1].x + (stations_[i].x - stations_[i - 1].x) * step / steps;
      const std::vector<double> values = valuesOf(line.at(std::min(x, line.end())));
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        EXPECT_GE(values[k], std::min(before[k], after[k]) - line_rounding) << "x = " << x << ", quantity " << k;
        EXPECT_LE(values[k], std::max(before[k], after[k]) + line_rounding) << "x = " << x << ", quantity " << k;
      }
    }
  }
}

// The slopes on both sides of a station, from differences over h, differ by the curvature times h. The curvature is at
// most six times the largest change (0.04) over the square of the smallest interval (0.05 m): 96 1/m. Where a line
// repeats there is none either.
TEST_F(TrackLineTest, HasNoKinkAtAStation)
{
  stations_.back() = {stations_.back().x, stations_.front().cross_level, stations_.front().rail};
  const TrackLine line("random", stations_, 1e9, true);
  constexpr double h = 1e-6;  // [m]
  for (std::size_t i = 0; i < stations_.size(); ++i)
  {
    const double x = stations_[i].x;
    const std::vector<double> before = valuesOf(line.at(x - h)), here = valuesOf(line.at(x)),
                              after = valuesOf(line.at(x + h));
    for (std::size_t k = 0; k < here.size(); ++k)
    {
      EXPECT_NEAR((here[k] - before[k]) / h, (after[k] - here[k]) / h, 100 * h) << "x = " << x << ", quantity " << k;
    }
  }
}

TEST_F(TrackLineTest, ReproducesAStraightLine)
{
  const auto straight = [](double x) { return 1e-3 + 1e-4 * x; };
  std::vector<LineStation> stations;
  for (const LineStation& station : stations_)
  {
    stations.push_back(stationAt(station.x, straight(station.x)));
  }
  const TrackLine line("straight", stations);
  for (double x = line.begin(); x <= line.end(); x += 0.0137)
  {
    expectNear(line.at(x), stationAt(x, straight(x)), 10 * line_rounding);
  }
}

// The slope at a station is a mean of the slopes of both intervals, with an error of second order where their lengths
// are equal. The error of the value is then of third order. The stations are on a rising part of a sine.
TEST_F(TrackLineTest, ErrorIsOfThirdOrderAwayFromExtremes)
{
  const auto wave = [](double x) { return 0.01 * std::sin(x); };
  std::vector<double> errors;
  for (const double spacing : {0.2, 0.1, 0.05, 0.025})
  {
    const TrackLine line = lineThrough(wave, -1.4, 1.4, spacing);
    double error = 0;
    for (double x = -1; x <= 1; x += 1e-3)
    {
      error = std::max(error, std::abs(line.at(x).cross_level - wave(x)));
    }
    errors.push_back(error);
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
  {
    // 2.8: the order approaches 3 from below or above as the terms of fourth order vanish.
    EXPECT_GT(std::log2(errors[i - 1] / errors[i]), 2.8);
    EXPECT_LT(std::log2(errors[i - 1] / errors[i]), 3.3);
  }
}

// At an extreme the slope is zero, so that the curve does not overshoot. Four millimetre waves of 3 m with stations
// every 0.25 m lose at most the height of the wave above its chord, 1 - cos(pi / 12) = 3.4 % of the amplitude.
TEST_F(TrackLineTest, ShortestWaveOfD1IsReproducedWithinItsSagBetweenStations)
{
  const double amplitude = 4e-3, wavelength = 3, spacing = 0.25, pi = std::acos(-1.0);
  const auto wave = [=](double x) { return amplitude * std::sin(2 * pi * x / wavelength + 0.7); };
  const TrackLine line = lineThrough(wave, 0, 30, spacing);
  double error = 0;
  for (double x = wavelength; x <= line.end() - wavelength; x += 1e-3)
  {
    error = std::max(error, std::abs(line.at(x).cross_level - wave(x)));
  }
  EXPECT_LT(error, amplitude * (1 - std::cos(pi * spacing / wavelength)));
}

TEST_F(TrackLineTest, ContainsItsEndsAndNothingBeyondThem)
{
  const TrackLine line("line", {stationAt(-1, 0), stationAt(2, 1e-3)});
  EXPECT_TRUE(line.contains(-1) && line.contains(0.3) && line.contains(2));
  EXPECT_FALSE(line.contains(std::nextafter(-1, -2)) || line.contains(std::nextafter(2, 3)));
  EXPECT_FALSE(line.contains(std::nan("")));
}

TEST_F(TrackLineTest, RepeatsOrNamesTheStep)
{
  stations_.back() = {stations_.back().x, stations_.front().cross_level, stations_.front().rail};
  const TrackLine line("line", stations_, 0.9, true);
  const double length = stations_.back().x - stations_.front().x, rounding = 1e-9;  // of a place, times slopes below 1
  for (const double x : {0.0, 3.21, 77.7, 140.0, line.places().back()})
  {
    for (const double repetition : {-3.0, 1.0, 1000.0})
    {
      expectNear(line.at(x + repetition * length), line.at(x), rounding);
      EXPECT_EQ(line.contains(x + repetition * length), line.contains(x));
    }
  }
  const double gap = 0.5 * (stations_[9].x + stations_[10].x);
  EXPECT_EQ(TrackLine("gaps", stations_, 1e-3, true).gapAt(gap + length)->front(), stations_[9].x + length);
  stations_.back().rail.left.vertical += 2e-6;
  EXPECT_EQ(refusalOf([&] { TrackLine("line", stations_, 1, true); }),
            "line: repeat: a step of 2e-06 in rail_vertical_left (SI units) from the last station to the first one");
}

TEST_F(TrackLineTest, InvalidStationsAreRefusedByNumber)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal({}), "line: a line needs at least two stations");
  EXPECT_EQ(refusal({stationAt(0, 0)}), "line: a line needs at least two stations");
  EXPECT_EQ(refusal({stationAt(0, 0), stationAt(0, 0)}), "line: station 2: x must increase");
  EXPECT_EQ(refusal({stationAt(0, 0), stationAt(1, 0), stationAt(0.5, 0)}), "line: station 3: x must increase");
  for (const double bad : {std::nan(""), infinity})
  {
    EXPECT_EQ(refusal({stationAt(0, 0), stationAt(bad, 0)}), "line: station 2: x must increase");
    EXPECT_EQ(refusal({stationAt(-bad, 0), stationAt(0, 0)}), "line: station 1: x must increase");
  }
  for (std::size_t k = 0; k < 7; ++k)
  {
    for (const double bad : {0.2001, -0.2001, std::nan(""), infinity})
    {
      std::vector<double> values(7, 0.0);
      values[k] = bad;
      const LineStation station{
          1, values[0], {RailDeflection{values[1], values[2], values[3]}, {values[4], values[5], values[6]}}};
      EXPECT_EQ(refusal({stationAt(0, 0), station, stationAt(2, 0)}),
                "line: station 2: a cross level or displacement is above 0.2 m or 0.2 rad")
          << "quantity " << k;
    }
  }
  EXPECT_EQ(refusal({{0, 0, {}, {300, 0, 0}}, {1, 0, {}}}),
            "line: station 1: curvature, cant or gradient is above 0.2 1/m, 0.2 rad or 0.2");
}
}  // namespace
