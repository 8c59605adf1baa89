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
    const std::vector<double> values = valuesOf(found), expected = valuesOf(station);
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      // The polynomial of an interval is evaluated at its end: rounding of its terms.
      EXPECT_NEAR(values[k], expected[k], 10 * line_rounding) << "x = " << station.x << ", quantity " << k;
    }
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
// most six times the largest change (0.04) over the square of the smallest interval (0.05 m): 96 1/m.
TEST_F(TrackLineTest, HasNoKinkAtAStation)
{
  const TrackLine line("random", stations_);
  constexpr double h = 1e-6;  // [m]
  for (std::size_t i = 1; i + 1 < stations_.size(); ++i)
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
    const std::vector<double> values = valuesOf(line.at(x)), expected = valuesOf(stationAt(x, straight(x)));
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      EXPECT_NEAR(values[k], expected[k], 10 * line_rounding) << "x = " << x << ", quantity " << k;
    }
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
  EXPECT_TRUE(line.contains(-1));
  EXPECT_TRUE(line.contains(0.3));
  EXPECT_TRUE(line.contains(2));
  EXPECT_FALSE(line.contains(std::nextafter(-1, -2)));
  EXPECT_FALSE(line.contains(std::nextafter(2, 3)));
  EXPECT_FALSE(line.contains(std::nan("")));
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
}

constexpr double gauge = 1.435;  ///< nominal [m]

class LineFileTest : public testing::Test
{
 protected:
  TrackLine read(const std::string& table, LineAxes axes = LineAxes::rep103) const
  {
    return readTrackLine(folder_.write("line.csv", table), gauge, axes);
  }
  /// Message with which a table is refused, without the path of the file.
  std::string refusal(const std::string& table) const
  {
    const std::string message = refusalOf([&] { read(table); }), path = folder_.path("line.csv");
    EXPECT_EQ(message.substr(0, path.size()), path);
    return message.substr(path.size());
  }

  const wheel_rail_contact::Folder folder_;
};

void expectSame(const LineStation& a, const LineStation& b)
{
  constexpr double tolerance = 1e-16;  // of differences of gauges [m], and of the conversion of units
  EXPECT_EQ(a.x, b.x);
  EXPECT_NEAR(a.cross_level, b.cross_level, tolerance);
  for (const Side side : sides)
  {
    EXPECT_NEAR(a.rail[side].lateral, b.rail[side].lateral, tolerance);
    EXPECT_NEAR(a.rail[side].vertical, b.rail[side].vertical, tolerance);
    EXPECT_NEAR(a.rail[side].roll, b.rail[side].roll, tolerance);
  }
}

struct Mistake
{
  const char* table;
  const char* message;
};

TEST_F(LineFileTest, ColumnsOfTheRailsAreTheirDisplacements)
{
  const TrackLine line = read(
      "x [m], rail_lateral_left [mm], rail_vertical_left [mm], rail_roll_left [mrad], rail_lateral_right [mm], "
      "rail_vertical_right [mm], rail_roll_right [mrad]\n"
      "-5, 1, 2, 3, 4, 5, 6\n"
      "7.5, 0, 0, 0, 0, 0, 0\n");
  EXPECT_EQ(line.begin(), -5);
  EXPECT_EQ(line.end(), 7.5);
  EXPECT_EQ(line.name(), folder_.path("line.csv"));
  expectSame(line.at(-5), {-5, 0, {RailDeflection{1e-3, 2e-3, 3e-3}, {4e-3, 5e-3, 6e-3}}});
  expectSame(line.at(7.5), {7.5, 0, {}});
}

TEST_F(LineFileTest, UnitsSeparatorsAndCommentsGiveTheSameLine)
{
  const LineStation expected{2, 3e-3, {RailDeflection{2.5e-3, 1e-3, 0}, {2.5e-3, 1e-3, 0}}};
  for (const char* table :
       {"x [m],gauge [mm],level [mm],cross_level [mm]\n2,1440,1,3\n3,1435,0,0\n",
        "x[m];gauge[m];level[um];cross_level[m]\n2;1.44;1000;0.003\n3;1.435;0;0",
        "x [ m ]\tgauge [um]\tlevel [m]\tcross_level [um]\r\n2\t1440000\t1e-3\t+3000\r\n3\t1435e3\t0\t0",
        "\xEF\xBB\xBF# measured\n\ncross_level [mm], x [mm], level [mm], gauge [mm]\n # run 1\n"
        "3, 2000, 1, 1440\n\n0, 3000, 0, 1435\n"})
  {
    SCOPED_TRACE(table);
    expectSame(read(table).at(2), expected);
  }
  const double pi = std::acos(-1.0);
  for (const char* title : {"rail_roll_left [rad]\n0,0.01\n1,0", "rail_roll_left [mrad]\n0,10\n1,0"})
  {
    expectSame(read(std::string("x [m],") + title).at(0), {0, 0, {RailDeflection{0, 0, 0.01}, {}}});
  }
  expectSame(read("x [m],rail_roll_left [deg]\n0,1\n1,0").at(0), {0, 0, {RailDeflection{0, 0, pi / 180}, {}}});
}

// y right and z down: lateral positions and heights change their sign. Gauge, cross level, and the outward displacement
// and roll of a rail do not depend on the axes.
TEST_F(LineFileTest, RailwayAxesDescribeTheSameLine)
{
  const TrackLine line = read(
      "x [m],gauge [mm],alignment_left [mm],alignment_right [mm],level_left [mm],level_right [mm],cross_level [mm]\n"
      "0,1440,3,-1,2,5,7\n1,1435,0,0,0,0,0\n");
  const TrackLine railway = read(
      "x [m],gauge [mm],alignment_left [mm],alignment_right [mm],level_left [mm],level_right [mm],cross_level [mm]\n"
      "0,1440,-3,1,-2,-5,7\n1,1435,0,0,0,0,0\n",
      LineAxes::railway);
  const TrackLine middle = read("x [m],alignment [mm],level [mm],gauge [mm]\n0,3,4,1440\n1,0,0,1435\n");
  const TrackLine railway_middle =
      read("x [m],alignment [mm],level [mm],gauge [mm]\n0,-3,-4,1440\n1,0,0,1435\n", LineAxes::railway);
  const TrackLine rails = read(
      "x [m],rail_lateral_right [mm],rail_vertical_right [mm],rail_roll_right [mrad]\n"
      "0,3,4,5\n1,0,0,0\n");
  const TrackLine railway_rails =
      read("x [m],rail_lateral_right [mm],rail_vertical_right [mm],rail_roll_right [mrad]\n0,3,-4,5\n1,0,0,0\n",
           LineAxes::railway);
  for (const double x : {0.0, 0.4, 1.0})
  {
    expectSame(line.at(x), railway.at(x));
    expectSame(middle.at(x), railway_middle.at(x));
    expectSame(rails.at(x), railway_rails.at(x));
  }
}

TEST_F(LineFileTest, MistakesAreRefusedWithLineAndReason)
{
  const std::string names =
      "x, gauge, alignment, alignment_left, alignment_right, level, level_left, level_right, cross_level, "
      "rail_lateral_left, rail_vertical_left, rail_roll_left, rail_lateral_right, rail_vertical_right, rail_roll_right";
  const std::string unknown = ":1: column 'cant': unknown quantity; valid names are " + names;
  const std::string half_open = ":1: column 'gauge [mm': unknown quantity; valid names are " + names;
  const std::string with_more = ":1: column 'gauge [mm] left': unknown quantity; valid names are " + names;
  const std::vector<Mistake> mistakes{
      {"", ": is empty"},
      {"# only a comment\n\n", ": is empty"},
      {"x [m],cant [mm]\n0,0\n1,0\n", unknown.c_str()},
      {"x [m],gauge\n", ":1: column 'gauge': must have a unit, for example 'gauge [mm]'"},
      {"x [m],gauge [mm\n", half_open.c_str()},
      {"x [m],gauge [mm] left\n", with_more.c_str()},
      {"x [m],\n0,\n", ": a line needs at least two stations"},
      {"x [m],gauge [ell]\n", ":1: column 'gauge': unknown unit 'ell'; valid units are m, cm, mm, um, in"},
      {"x [m],gauge [mrad]\n", ":1: column 'gauge': unknown unit 'mrad'; valid units are m, cm, mm, um, in"},
      {"x [m],rail_roll_left [mm]\n", ":1: column 'rail_roll_left': unknown unit 'mm'; valid units are rad, mrad, deg"},
      {"# a\n\nx [m],level [mm],x [mm]\n", ":3: column 'x' is given twice"},
      {"gauge [mm]\n1435\n1435\n", ":1: column 'x' is missing"},
      {"x [m],alignment [mm],alignment_left [mm]\n", ":1: give either 'alignment' or 'alignment_left'"},
      {"x [m],alignment_right [mm],alignment [mm]\n", ":1: give either 'alignment' or 'alignment_right'"},
      {"x [m],level [mm],level_left [mm]\n", ":1: give either 'level' or 'level_left'"},
      {"x [m],level [mm],level_right [mm]\n", ":1: give either 'level' or 'level_right'"},
      {"x [m],rail_roll_left [rad],gauge [mm]\n", ":1: give either 'gauge' or 'rail_roll_left'"},
      {"x [m],cross_level [mm],rail_lateral_right [mm]\n", ":1: give either 'cross_level' or 'rail_lateral_right'"},
      {"x [m],level [mm]\n0,0\n# remark\n1,one\n", ":4: column 'level': 'one' is not a finite number"},
      {"x [m],level [mm]\n0,nan\n", ":2: column 'level': 'nan' is not a finite number"},
      {"x [m],level [mm]\n0,inf\n", ":2: column 'level': 'inf' is not a finite number"},
      {"x [m],level [mm]\n0,1 mm\n", ":2: column 'level': '1 mm' is not a finite number"},
      {"x [m],level [mm]\n,1\n", ":2: column 'x': '' is not a finite number"},
      {"x [m],level [mm]\n0,0\n1\n", ":3: number of columns is 1, must be 2"},
      {"x [m],level [mm]\n0,0,0\n", ":2: number of columns is 3, must be 2"},
      {"x [m],level [mm]\n0,0\n1,0\n1,0\n", ":4: x must increase"},
      {"x [m],level [mm]\n0,0\n1,0\n0.5,0\n", ":4: x must increase"},
      {"x [m],gauge [mm]\n0,1435\n1,5\n",
       ":3: gauge = 0.005000 m: must be the whole gauge, within 0.2 m of track/gauge"},
      {"x [m],gauge [m]\n0,1435\n", ":2: gauge = 1435.000000 m: must be the whole gauge, within 0.2 m of track/gauge"},
      {"x [m],level [m]\n0,0\n\n1,0.3\n", ":4: a cross level or displacement is above 0.2 m or 0.2 rad"},
      {"x [m],rail_roll_left [deg]\n0,12\n", ":2: a cross level or displacement is above 0.2 m or 0.2 rad"},
      {"x [m],level_left [m],level_right [m]\n0,0.15,-0.15\n",
       ":2: a cross level or displacement is above 0.2 m or 0.2 rad"},
      {"x [m],level [mm]\n", ": a line needs at least two stations"},
      {"x [m],level [mm]\n0,0\n", ": a line needs at least two stations"},
  };
  for (const Mistake& mistake : mistakes)
  {
    EXPECT_EQ(refusal(mistake.table), mistake.message) << mistake.table;
  }
}

TEST_F(LineFileTest, FilesThatCannotBeReadAreRefused)
{
  EXPECT_THROW(readTrackLine(folder_.path("missing.csv"), gauge), std::invalid_argument);
  EXPECT_THROW(readTrackLine(folder_.path("."), gauge), std::invalid_argument);
}
}  // namespace
