// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

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
    return readTrackLine(folder_.write("line.csv", table), gauge, axes);
  }
  /// Message with which a table is refused, without the path of the file; "accepted" if it is not.
  std::string refusal(const std::string& table) const
  {
    try
    {
      read(table);
    }
    catch (const std::invalid_argument& error)
    {
      const std::string message = error.what(), path = folder_.path("line.csv");
      EXPECT_EQ(message.substr(0, path.size()), path);
      return message.substr(path.size());
    }
    return "accepted";
  }

  const test::Folder folder_;
};

void expectSame(const LineStation& a, const LineStation& b)
{
  constexpr double rounding = 1e-16;  // of differences of gauges [m], and of the conversion of units
  EXPECT_EQ(a.x, b.x);
  EXPECT_NEAR(a.cross_level, b.cross_level, rounding);
  for (const Side side : sides)
  {
    EXPECT_NEAR(a.rail[side].lateral, b.rail[side].lateral, rounding);
    EXPECT_NEAR(a.rail[side].vertical, b.rail[side].vertical, rounding);
    EXPECT_NEAR(a.rail[side].roll, b.rail[side].roll, rounding);
  }
}

struct Mistake
{
  const char* table;
  const char* message;
};
}  // namespace

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
