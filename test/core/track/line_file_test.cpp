// SPDX-License-Identifier: BSD-3-Clause
#include "../profile/profile_helpers.h"
#include "wheel_rail_contact/core/track.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double gauge = 1.435;  ///< nominal [m]

class LineFileTest : public testing::Test
{
 protected:
  TrackLine read(const std::string& table, LineAxes axes = LineAxes::rep103) const
  {
    return readTrackLine(folder_.write("line.csv", table), gauge, {axes});
  }
  /// Doubts on a measured line of 60 m, with a wave of 7 m and 3 mm, after a change of its rows in mm.
  std::vector<std::string> doubts(const std::function<void(int, std::array<double, 4>&)>& change) const
  {
    std::string table = "x [m],gauge [mm],alignment_left [mm],alignment_right [mm]\n";
    for (int i = 0; i <= 240; ++i)
    {
      const double wave = 3 * std::sin(2 * M_PI * 0.25 * i / 7);
      std::array<double, 4> row{0.25 * i, 1435 + 2 * wave, wave, -wave};
      change(i, row);
      table += std::to_string(row[0]) + "," + std::to_string(row[1]) + "," + std::to_string(row[2]) + "," +
               std::to_string(row[3]) + "\n";
    }
    LineReport report;
    readTrackLine(folder_.write("line.csv", table), gauge, {}, &report);
    return report.doubts;
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
  EXPECT_EQ(std::tie(a.design.curvature, a.design.cant, a.design.gradient),
            std::tie(b.design.curvature, b.design.cant, b.design.gradient));
  for (const Side side : sides)
  {
    EXPECT_NEAR(a.rail[side].lateral, b.rail[side].lateral, tolerance);
    EXPECT_NEAR(a.rail[side].vertical, b.rail[side].vertical, tolerance);
    EXPECT_NEAR(a.rail[side].roll, b.rail[side].roll, tolerance);
  }
}

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
  for (const char* title : {"[rad]\n0,0.01\n1,0", "[mrad]\n0,10\n1,0", "[deg]\n0,0.5729577951308232\n1,0"})
  {
    expectSame(read(std::string("x [m],rail_roll_left ") + title).at(0), {0, 0, {RailDeflection{0, 0, 0.01}, {}}});
  }
}

// y right and z down: lateral positions, heights and curvatures change their sign. Gauge, cross level, cant, gradient,
// and the outward displacement and roll of a rail do not depend on the axes.
TEST_F(LineFileTest, RailwayAxesDescribeTheSameLine)
{
  const std::string both = "gauge [mm],alignment_left [mm],alignment_right [mm],level_left [mm],level_right [mm]";
  const std::vector<std::array<std::string, 3>> lines{
      {both + ",cross_level [mm]\n0,1440,", "3,-1,2,5,7", "-3,1,-2,-5,7\n1,1435,0,0,0,0,0\n"},
      {"gauge [mm],alignment [mm],level [mm]\n0,1440,", "3,4", "-3,-4\n1,1435,0,0\n"},
      {"rail_lateral_right [mm],rail_vertical_right [mm],rail_roll_right [mrad]\n0,", "3,4,5", "3,-4,5\n1,0,0,0\n"},
      {"curvature [1/km],cant [mm],gradient [%]\n0,", "3,60,0.5", "-3,60,0.5\n1,0,0,0\n"}};
  for (const auto& [begin, of_first, railway] : lines)
  {
    const TrackLine line = read("x [m]," + begin + of_first + railway.substr(railway.find('\n')));
    const TrackLine other = read("x [m]," + begin + railway, LineAxes::railway);
    for (const double x : {0.0, 0.4, 1.0})
    {
      expectSame(line.at(x), other.at(x));
    }
  }
}

TEST_F(LineFileTest, MistakesAreRefusedWithLineAndReason)
{
  const std::string names =
      "x, gauge, alignment, alignment_left, alignment_right, level, level_left, level_right, cross_level, "
      "rail_lateral_left, rail_vertical_left, rail_roll_left, rail_lateral_right, rail_vertical_right, "
      "rail_roll_right, curvature, cant, gradient";
  const std::string unknown = ":1: column 'cant_left': unknown quantity; valid names are " + names;
  const std::string half_open = ":1: column 'gauge [mm': unknown quantity; valid names are " + names;
  const std::string with_more = ":1: column 'gauge [mm] left': unknown quantity; valid names are " + names;
  const std::string none = ":1: no column has an irregularity or a design; valid names are " + names;
  const std::string lengths = ":1: column 'gauge': unknown unit ";
  const std::string filler = ": another unit, or a filler for a missing value, which must be an empty cell";
  const std::string whole =
      " m: must be the whole gauge, within 0.2 m of track/gauge, or in all rows the deviation from it";
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"", ": is empty"},
      {"# only a comment\n\n", ": is empty"},
      {"x [m],cant_left [mm]\n0,0\n1,0\n", unknown},
      {"x [m],gauge\n", ":1: column 'gauge': must have a unit, for example 'gauge [mm]'"},
      {"x [m],gauge [mm\n", half_open},
      {"x [m],gauge [mm] left\n", with_more},
      {"x [m],twist [mm/m]\n0,0\n", none},
      {"Station [m];Spurweite [mm]\n0;1435\n", none},
      {"place [m],gauge [mm]\n0,1435\n", ":1: column 'x' is missing; others are place"},
      {"x [m],gauge [ell]\n", lengths + "'ell'; valid units are m, mm, um, cm, km, in, ft, mi"},
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
      {"x [m],level [mm]\n0,0\n1,nan\n,1\n", ":3: 2 of 3 rows lack a value"},
      {"x [m],level [mm]\n0,inf\n", ":2: column 'level': 'inf' is not a finite number"},
      {"x [m],level [mm]\n0,1 mm\n", ":2: column 'level': '1 mm' is not a finite number"},
      {"x [m],level [mm]\n0,0,0\n", ":2: number of columns is 3, must be 2"},
      {"x [m],level [mm]\n0,0\n1,0\n1,0\n", ":4: x must increase"},
      {"x [m],level [mm]\n0,0\n1,0\n0.5,0\n", ":4: x must increase"},
      {"x [m],level [mm]\n2,0\n1,0\n1.5,0\n", ":4: x must decrease, as from the first row to the last"},
      {"x [m],gauge [mm]\n0,1435\n1,5\n", ":3: gauge = 0.005000" + whole},
      {"x [m],gauge [mm]\n0,0\n1,1435\n", ":3: gauge = 1.435000" + whole},
      {"x [m],gauge [m]\n0,1435\n", ":2: gauge = 1435.000000" + whole},
      {"x [m],level [m]\n0,0\n\n1,0.3\n", ":4: column 'level': a value of 0.3 m" + filler},
      {"x [m],level [mm]\n0,0\n1,-9999\n", ":3: column 'level': a value of -9.999 m" + filler},
      {"x [m],level [mm]\n0,0\n0.25,32.767\n", ":3: column 'level': a change by 0.03277 m within 0.25 m" + filler},
      {"x [m],level [mm]\n0,1\n5,99.9\n", ":3: column 'level': a change by 0.0989 m within 5 m" + filler},
      {"x [m],level [mm]\n0,99.99\n5,1\n", ":3: column 'level': a change by -0.09899 m within 5 m" + filler},
      {"x [m],rail_roll_left [deg]\n0,12\n", ":2: column 'rail_roll_left': a value of 0.2094 rad" + filler},
      {"x [m],level_left [m],level_right [m]\n0,0.15,-0.15\n1,0.15,-0.15\n",
       ": station 1: a cross level or displacement is above 0.2 m or 0.2 rad"},
      {"x [m],level [mm]\n", ": a line needs at least two stations"},
      {"x [m],curvature [m]\n0,300\n", ":1: column 'curvature': unknown unit 'm'; valid units are 1/m, 1/km"},
      {"x [m],curvature [1/km]\n0,0\n9,0\n9,3\n",
       ":4: a second row at this x: a design has one curvature, cant and gradient at each place, the end of one "
       "element "
       "and begin of the next; a step of the curvature is a short clothoid"},
      {"x [m],curvature [1/km]\n0,0\n9,300\n",
       ":3: column 'curvature': a value of 0.3 1/m: another unit, the radius" + filler.substr(filler.find(','))},
      {"x [m],gradient\n0,0\n", ":1: column 'gradient': must have a unit, for example 'gradient [permil]'"},
      {"x [m],cant [mm],cross_level [mm]\n0,0,1\n9,100,103\n",
       ":3: cross_level is 103 mm and cant 100 mm: beside a column 'cant', the cross level is the deviation from it"},
      {"x [m],level [mm]\n0,0\n", ": a line needs at least two stations"},
  };
  for (const auto& [table, message] : mistakes)
  {
    EXPECT_EQ(refusal(table), message) << table;
  }
  EXPECT_THROW(readTrackLine(folder_.path("missing.csv"), gauge), std::invalid_argument);
  EXPECT_THROW(readTrackLine(folder_.path("."), gauge), std::invalid_argument);
}

// The same line as programs of track recording cars write it; the second station is twice as far away as the others.
TEST_F(LineFileTest, TablesOfTrackRecordingCarsGiveTheSameLine)
{
  const std::string expected = "4 stations from 1000 to 1001 m; longest gap 0.75 m";
  const std::string deviation = "4 stations from 1000 to 1001 m; gauge as deviation from 1.435 m; longest gap 0.75 m";
  const std::string reversed =
      "4 stations from 1000 to 1001 m; x decreases in the file: left and right are taken as seen towards increasing x; "
      "longest gap 0.75 m";
  const std::vector<std::pair<std::string, std::string>> tables{
      {"x [m],gauge [mm],level [mm]\n1000,1435,1\n1000.5,1437,2\n1000.75,1436,2\n1001,1435,0\n", expected},
      {"x [km],gauge [m],level [mm]\n1,1.435,1\n1.0005,1.437,2\n1.00075,1.436,2\n1.001,1.435,0\n", expected},
      {"km;m;gauge [mm];level [mm]\n0;1000;1435;1\n1;0,5;1437;2\n1;0,75;1436;2\n1;1;1435;0\n", expected},
      {"Run 12\nkm;m;gauge [mm];level [mm]\n0;1000;1435;1\n1;0,5;1437;2\n1;0,75;1436;2\n1;1;1435;0\n", expected},
      {"Distance (m)\tGauge (mm)\tLevel (mm)\n1000\t0\t1\n1000.5\t2\t2\n1000.75\t1\t2\n1001\t0\t0\n", deviation},
      {"run 7\nx,gauge,level\nm,mm,mm\n1001,1435,0\n1000.75,1436,2\n1000.5,1437,2\n1000,1435,1\n", reversed},
      {"chainage [m],twist_3m [mm/m],gauge [mm],speed [km/h],level [mm]\n1000,0,1435,80,1\n1000.25,0,NaN,80,1\n"
       "1000.5,0,1437,80,2\n1000.6,0,1437,80,\n1000.75,0,1436,80,2\n1001,0,1435,80,0\n",
       expected + "; 2 rows lack a value, the first in line 3; ignored columns: twist_3m, speed"}};
  const TrackLine line = read(tables.front().first);
  for (const auto& [table, understood] : tables)
  {
    SCOPED_TRACE(table);
    LineReport report;
    const TrackLine same = readTrackLine(folder_.write("same.csv", table), gauge, {}, &report);
    EXPECT_EQ(report.text, understood);
    EXPECT_TRUE(report.doubts.empty());
    for (const double x : {1000.0, 1000.3, 1000.9})
    {
      constexpr double rounding = 2e-15;  // of a place, 1e-13 m, times the slope [m]
      EXPECT_NEAR(same.at(x).rail.left.vertical, line.at(x).rail.left.vertical, rounding);
      EXPECT_NEAR(same.at(x).rail.right.lateral, line.at(x).rail.right.lateral, rounding);
    }
  }
}

// 10 m are missing where stations are 0.25 m apart, as when a measuring car loses its signal.
TEST_F(LineFileTest, NothingIsKnownAcrossAGap)
{
  std::string table = "x [m],level [mm]\n";
  LineReport report;
  for (double x = 0; x <= 20; x += 0.25)
  {
    table += x > 5 && x < 15 ? "" : std::to_string(x) + "," + std::to_string(3 * std::sin(x)) + "\n";
  }
  const std::string path = folder_.write("line.csv", table);
  const TrackLine line = readTrackLine(path, gauge, {}, &report);
  EXPECT_EQ(report.text, "42 stations from 0 to 20 m; longest gap 0.75 m, exceeded from 5 to 15 m");
  EXPECT_TRUE(line.contains(5) && line.contains(15) &&
              readTrackLine(path, gauge, {LineAxes::rep103, 10}).contains(7.5));
  EXPECT_FALSE(line.contains(std::nextafter(5, 6)) || line.contains(std::nextafter(15, 14)) || line.gapAt(4.9));
  EXPECT_EQ(line.gapAt(7.5), (std::array<double, 2>{5, 15}));
  // The values beyond the gap have no effect before it: the slope at 5 m is that of the last interval.
  const TrackLine before("before", {{4.75, 1e-3, {}}, {5, 2e-3, {}}, {15, 9e-3, {}}}, 1);
  EXPECT_DOUBLE_EQ(before.at(4.875).cross_level, 1.5e-3);
}

// Once without a word: columns that contradict each other, a channel that stays, wrong units.
TEST_F(LineFileTest, DoubtfulColumnsAreNamed)
{
  using Doubts = std::vector<std::string>;
  EXPECT_EQ(doubts([](int, auto& row) { row[1] += 0.15; }), Doubts{});
  EXPECT_EQ(doubts([](int i, auto& row) { row[1] = 1435, row[2] = row[3] = std::min(0.1 * i, 15.0); }),
            Doubts{});  // ramp
  EXPECT_EQ(
      doubts([](int, auto& row) { row[1] = 1435; }),
      Doubts{"'gauge' and both 'alignment' disagree by up to 6 mm: at x = 1.75 m it deviates by 0 mm from the ideal "
             "track, they by 6 mm; 'gauge' is kept, with the mean of both"});
  // 40 rows of a lost signal; six rows of a filler that contains no nines.
  const Doubts frozen = doubts(
      [](int i, auto& row) {
        row = i > 100 && i < 140 ? std::array<double, 4>{row[0], 1436, 0.5, -0.5} : row;
      });
  ASSERT_EQ(frozen.size(), 3U);
  EXPECT_EQ(frozen[1], "column 'alignment_left' is the same in 39 rows, from x = 25.25 to 34.75 m: a lost signal?");
  const Doubts filler = doubts([](int i, auto& row) { row[1] = i > 100 && i < 107 ? 1452.5 : row[1]; });
  ASSERT_EQ(filler.size(), 2U);
  EXPECT_EQ(filler[1], "column 'gauge' is the same in 6 rows, from x = 25.25 to 26.5 m: a lost signal?");
  const auto in_metres = [](int, auto& row) { row = {row[0], 1435, 1e-3 * row[2], 1e-3 * row[2]}; };
  EXPECT_EQ(doubts(in_metres), (Doubts{"column 'alignment_left' is at most 0.003 in its unit: another one?",
                                       "column 'alignment_right' is at most 0.003 in its unit: another one?"}));
  for (const double scale : {1e3, 1e-3})
  {
    const Doubts places = doubts([&](int, auto& row) { row = {scale * row[0], 1435, 0.01 * row[2], 0.01 * row[2]}; });
    ASSERT_EQ(places.size(), 1U);
    EXPECT_EQ(places[0],
              std::string("the stations are ") + (scale > 1 ? "250" : "0.00025") + " m apart: is x in another unit?");
  }
  EXPECT_THROW(doubts([](int i, auto& row) { row[2] = i > 100 && i < 110 ? -9.999 : row[2]; }), std::invalid_argument);
}

// A cant of 99.9 mm is a filler only beside other values; a roughness of 99.9 um, and 999.9 mm on the metre gauge,
// never.
TEST_F(LineFileTest, NinesAmongTheirLikeAreNoFiller)
{
  EXPECT_NEAR(read("x [m],cross_level [mm]\n0,99.7\n1,99.9\n2,100.1\n").at(1).cross_level, 0.0999, 1e-16);
  EXPECT_NEAR(read("x [m],level [um]\n0,40.1\n1,99.9\n2,12\n").at(1).rail.left.vertical, 99.9e-6, 1e-16);
  const std::string metre_gauge = folder_.write("line.csv", "x [m],gauge [mm]\n0,1000.2\n1,999.9\n2,1000.1\n");
  EXPECT_NEAR(readTrackLine(metre_gauge, 1).at(1).rail.left.lateral, -0.05e-3, 1e-15);
}

// Clothoids by their ends. The rule on gaps holds for irregularities only.
TEST_F(LineFileTest, DesignIsLinearBetweenItsStations)
{
  LineReport report;
  const std::string path = folder_.write("design.csv",
                                         "x;curvature;cant;gradient\nm;1/km;mm;permil\n0;0;0;10\n100;0;0;10\n"
                                         "150;4;-100;10\n400;4;-100;-5\n");
  const TrackLine alone = readTrackLine(path, gauge, {}, &report);
  EXPECT_EQ(report.text, "4 stations from 0 to 400 m; smallest radius 250 m, to the left");
  const std::string other =
      "x [m],level [mm],curvature [1/m],superelevation [cm]\n100,2,0,0\n150,2,4e-3,10\n400,1,4e-3,10";
  const TrackLine with_level = readTrackLine(folder_.write("line.csv", other), gauge, {LineAxes::rep103, 100}, &report);
  EXPECT_EQ(report.text,
            "3 stations from 100 to 400 m; smallest radius 250 m, to the left; longest gap 100 m, exceeded from 150 to "
            "400 m");
  EXPECT_EQ(report.doubts, std::vector<std::string>{"at x = 150 m the cant raises the inner rail: another sign?"});
  EXPECT_TRUE(with_level.contains(125) && alone.contains(280) && !with_level.contains(280));
  for (const double x : {50.0, 125.0, 150.0, 280.0, 400.0})
  {
    const double along = std::clamp((x - 100) / 50, 0.0, 1.0);
    EXPECT_NEAR(alone.designAt(x).curvature, 4e-3 * along, 1e-15);
    EXPECT_NEAR(with_level.designAt(x).curvature, 4e-3 * along, 1e-15);
    EXPECT_NEAR(alone.designAt(x).cant, -std::asin(0.1 / 1.5) * along, 1e-15);
    EXPECT_NEAR(alone.designAt(x).gradient, 0.01 - 0.015 * std::max(x - 150, 0.0) / 250, 1e-15);
  }
}
}  // namespace
