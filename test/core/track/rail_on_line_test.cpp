// SPDX-License-Identifier: BSD-3-Clause
// Places of the rails on a line, measured on placed rails by the definitions of EN 13848-1.
#include "core/track/rail_along.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../../manchester_scene.h"
#include "../profile/profile_helpers.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double rounding = 1e-15;  ///< rounding error of sums of lengths below 2 m [m]

/// Places of a rail in track axes, measured on the surface of its head.
struct RailMeasure
{
  double face = 0;   ///< y of the innermost point down to the gauge depth below the highest point [m]
  double top = 0;    ///< z of the highest point [m]
  double angle = 0;  ///< of the rail relative to its side axes [rad]: inclination minus outward roll
};

RailMeasure measured(const PlacedRail& rail, Side side, double gauge_depth)
{
  constexpr int count = 20000;
  RailMeasure measure{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), rail.angle()};
  const auto at = [&](int i) { return rail.at(rail.profile().length() * i / count); };
  for (int i = 0; i <= count; ++i)
  {
    measure.top = std::max(measure.top, at(i).z);
  }
  for (int i = 0; i <= count; ++i)
  {
    measure.face = at(i).z >= measure.top - gauge_depth ? std::min(measure.face, at(i).y) : measure.face;
  }
  measure.face *= sideSign(side);
  return measure;
}

/// Both rails at one place of a line.
class RailOnLineTest : public testing::Test
{
 protected:
  /// Station of a table with the columns `titles` and the values `values`, all in mm.
  LineStation station(const std::string& titles, const std::string& values) const
  {
    std::string header = "x [mm]";
    for (const std::string& title : split(titles))
    {
      header += "," + title + " [mm]";
    }
    const std::string path = folder_.write("line.csv", header + "\n0," + values + "\n1," + values + "\n");
    return readTrackLine(path, scene_.track.gauge).at(0);
  }

  void place(const LineStation& station)
  {
    displaced_ =
        displacementsAt(station, {resting(Side::left).referencePoint(), resting(Side::right).referencePoint()});
    for (const Side side : sides)
    {
      rail_[side] = measured(placed(side), side, scene_.track.gauge_depth);
    }
  }

  /// Expects places of the gauge faces relative to those of the ideal track, y left [m].
  void expectFaces(double left, double right) const
  {
    // Sum of the errors of samples 7 um apart, on a face with a slope of 1:20.
    constexpr double sampling = 1e-6;
    EXPECT_NEAR(rail_.left.face - 0.5 * scene_.track.gauge, left, sampling);
    EXPECT_NEAR(rail_.right.face + 0.5 * scene_.track.gauge, right, sampling);
    EXPECT_NEAR(rail_.left.top, 0, 1e-9);  // error of samples 7 um apart on a radius of 0.3 m: 2e-11 m
    EXPECT_NEAR(rail_.right.top, 0, 1e-9);
  }

  /// Expects heights of the rail tops [m], and heads that are turned with the track [rad].
  void expectTops(double left, double right) const
  {
    // The highest points are up to 15 mm farther apart than the reference points, for which the cross level is exact:
    // 1 % of the cross level. On a tilted track they move by less than 2 um.
    const double difference = std::abs(left - right), tolerance = 0.5 * 0.01 * difference + 2e-6;
    EXPECT_NEAR(rail_.left.top, left, tolerance);
    EXPECT_NEAR(rail_.right.top, right, tolerance);
    // Distance of the reference points: 1.507 m.
    const double tilt = std::asin((left - right) / 1.507), inclination = scene_.track.rail_inclination.left;
    EXPECT_NEAR(rail_.left.angle - inclination, tilt, 1e-3 * std::abs(tilt) + rounding);
    EXPECT_NEAR(rail_.right.angle - inclination, -tilt, 1e-3 * std::abs(tilt) + rounding);
  }

  PlacedRail resting(Side side) const { return {scene_.rail_profile[side], scene_.track, side}; }
  PlacedRail placed(Side side) const { return resting(side).deflected(displaced_[side]); }

  static std::vector<std::string> split(const std::string& words)
  {
    std::istringstream stream(words);
    return {std::istream_iterator<std::string>(stream), {}};
  }

  const test::Folder folder_;
  ContactModelConfig scene_ = manchesterScene();
  Sides<RailDeflection> displaced_{};  ///< of each Side
  Sides<RailMeasure> rail_{};          ///< of each Side
};
}  // namespace

TEST_F(RailOnLineTest, IdealTrackDisplacesNothing)
{
  place({});
  for (const RailDeflection& rail : {displaced_.left, displaced_.right})
  {
    EXPECT_EQ(rail.lateral, 0);
    EXPECT_EQ(rail.vertical, 0);
    EXPECT_EQ(rail.roll, 0);
  }
  expectFaces(0, 0);
  expectTops(0, 0);
}

TEST_F(RailOnLineTest, GaugeAndAlignmentAreThoseOfTheGaugeFaces)
{
  struct Case
  {
    const char *titles, *values;
    double left, right;  ///< displacement of the gauge faces to the left [mm]
  };
  for (const Case& c : {Case{"gauge", "1441", 3, -3},
                        {"gauge", "1430", -2.5, 2.5},
                        {"alignment", "2", 2, 2},
                        {"alignment_left", "2", 2, 2},
                        {"alignment_right", "-2", -2, -2},
                        {"gauge alignment", "1441 2", 5, -1},
                        {"gauge alignment_left", "1441 2", 2, -4},
                        {"gauge alignment_right", "1441 2", 8, 2},
                        {"alignment_left alignment_right", "5 -3", 5, -3},
                        {"alignment_left alignment_right", "-4 -4", -4, -4},
                        {"gauge alignment_left alignment_right", "1439 4 0", 4, 0},
                        // The measurements disagree: the mean alignment of 1 mm and the gauge are kept.
                        {"gauge alignment_left alignment_right", "1441 4 -2", 4, -2},
                        {"gauge alignment_left alignment_right", "1441 2 0", 4, -2}})
  {
    SCOPED_TRACE(std::string(c.titles) + ": " + c.values);
    std::string values = c.values;
    std::replace(values.begin(), values.end(), ' ', ',');
    place(station(c.titles, values));
    expectFaces(1e-3 * c.left, 1e-3 * c.right);
    EXPECT_EQ(displaced_.left.roll, 0);
    EXPECT_EQ(displaced_.right.roll, 0);
  }
}

TEST_F(RailOnLineTest, LevelsAndCrossLevelAreThoseOfTheRailTops)
{
  struct Case
  {
    const char *titles, *values;
    double left, right;  ///< height of the rail tops [mm]
  };
  for (const Case& c : {Case{"level", "3", 3, 3},
                        {"level", "-3", -3, -3},
                        {"level_left", "3", 3, 3},
                        {"level_right", "3", 3, 3},
                        {"cross_level", "4", 2, -2},
                        {"cross_level", "-4", -2, 2},
                        {"level cross_level", "3 4", 5, 1},
                        {"level_left cross_level", "3 4", 3, -1},
                        {"level_right cross_level", "3 4", 7, 3},
                        {"level_left level_right", "5 1", 5, 1},
                        {"level_left level_right", "-1 6", -1, 6},
                        {"level_left level_right cross_level", "5 1 4", 5, 1},
                        // The measurements disagree: the mean level of 3 mm and the cross level are kept.
                        {"level_left level_right cross_level", "5 1 6", 6, 0}})
  {
    SCOPED_TRACE(std::string(c.titles) + ": " + c.values);
    std::string values = c.values;
    std::replace(values.begin(), values.end(), ' ', ',');
    place(station(c.titles, values));
    expectTops(1e-3 * c.left, 1e-3 * c.right);
  }
}

// The whole track turns about its centre line in the plane of the rail tops: a point of a rail keeps its distance from
// this line and turns by the angle of the track.
TEST_F(RailOnLineTest, CrossLevelTurnsBothRailsAboutTheCentreLine)
{
  for (const double cross_level : {0.15, 0.01, -0.08})
  {
    SCOPED_TRACE("cross level " + std::to_string(cross_level));
    place({0, cross_level, {}});
    const PlanePoint left = resting(Side::left).referencePoint(), right = resting(Side::right).referencePoint();
    const double tilt = std::asin(cross_level / (left.y + right.y));
    for (const Side side : sides)
    {
      const double angle = sideSign(side) * tilt;  // raises the rail
      EXPECT_NEAR(placed(side).angle() - resting(side).angle(), angle, rounding);
      for (double u = 0; u <= scene_.rail_profile[side]->length(); u += 0.01)
      {
        const PlanePoint before = resting(side).at(u), after = placed(side).at(u);
        EXPECT_NEAR(after.y, std::cos(angle) * before.y - std::sin(angle) * before.z, rounding);
        EXPECT_NEAR(after.z, std::sin(angle) * before.y + std::cos(angle) * before.z, rounding);
      }
    }
    const double height = placed(Side::left).referencePoint().z - placed(Side::right).referencePoint().z;
    EXPECT_NEAR(height, cross_level, rounding);
  }
}

// Gauge, alignment and level are measured in the tilted track.
TEST_F(RailOnLineTest, DisplacementsAreThoseInTheTiltedTrack)
{
  const LineStation in_plane{0, 0, {RailDeflection{3e-3, -2e-3, 1e-3}, {-1e-3, 4e-3, -2e-3}}};
  LineStation tilted = in_plane;
  tilted.cross_level = 0.1;
  place(in_plane);
  const Sides<PlacedRail> level{placed(Side::left), placed(Side::right)};
  place(tilted);
  const double tilt = std::asin(tilted.cross_level /
                                (resting(Side::left).referencePoint().y + resting(Side::right).referencePoint().y));
  for (const Side side : sides)
  {
    const double angle = sideSign(side) * tilt;
    for (double u = 0; u <= scene_.rail_profile[side]->length(); u += 0.01)
    {
      const PlanePoint before = level[side].at(u), after = placed(side).at(u);
      EXPECT_NEAR(after.y, std::cos(angle) * before.y - std::sin(angle) * before.z, rounding);
      EXPECT_NEAR(after.z, std::sin(angle) * before.y + std::cos(angle) * before.z, rounding);
    }
  }
}
