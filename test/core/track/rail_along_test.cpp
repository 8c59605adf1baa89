// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/rail_along.h"
#include "../../manchester_scene.h"
#include "../profile/profile_helpers.h"
#include "../profile/section_scenes.h"

using namespace wheel_rail_contact::core;
using namespace section_scenes;

// Places of the sections of a rail across the track.
namespace
{
using Placement = RailSections::Placement;

/// Points of a rail are 7 um apart. The highest point of a head turned by 1:40 is on a corner of 13 mm: (7 um)² / (8 *
/// 13 mm). The innermost point of a straight upright side is exact.
constexpr double sampling = 1e-9;
constexpr double turned_sampling = 2e-7;  ///< of the innermost point of a side turned by 1:40: 7 um / 40

/// Highest point of a part of a rail, and its innermost point down to the gauge depth; side axes [m].
struct Extremes
{
  double top = -std::numeric_limits<double>::infinity(), face = std::numeric_limits<double>::infinity();
};

Extremes extremesOf(const PlacedRail& rail, std::size_t part, double gauge_depth)
{
  constexpr int count = 20000;
  const ParameterRange range = rail.profile().parts().at(part);
  const auto at = [&](int i) { return rail.at(range.begin + (range.end - range.begin) * i / count); };
  Extremes extremes;
  for (int i = 0; i <= count; ++i)
  {
    extremes.top = std::max(extremes.top, at(i).z);
  }
  for (int i = 0; i <= count; ++i)
  {
    extremes.face = at(i).z >= extremes.top - gauge_depth ? std::min(extremes.face, at(i).y) : extremes.face;
  }
  return extremes;
}

RailSeries twoHeads(const Head& first, const Head& second)
{
  return {{0, shared(profileOf(first)), {}}, {1, shared(profileOf(second)), {}}};
}

void expectSamePlace(const PlacedRail& a, const PlacedRail& b)
{
  ASSERT_EQ(a.profile().length(), b.profile().length());
  for (double u = 0; u < a.profile().length(); u += 1e-3)
  {
    EXPECT_EQ(a.at(u).y, b.at(u).y);
    EXPECT_EQ(a.at(u).z, b.at(u).z);
  }
}

/// Upright rails.
TrackConfig upright()
{
  TrackConfig track;
  track.rail_inclination = 0;
  return track;
}

TEST(RailAlong, GaugePlacementPutsEachSectionToGaugeAndHeight)
{
  const RailSections sections({twoHeads({0.003, 0.002, 0.036}, {-0.001, -0.004, 0.030})}, Placement::gauge);
  for (const TrackConfig& track : {upright(), TrackConfig()})
  {
    for (const Side side : sides)
    {
      RailAlong along(sections, track, side);
      const bool turned = track.rail_inclination[side] != 0;
      for (const double x : {0.0, 1.0})
      {
        along.moveTo(x);
        const Extremes extremes = extremesOf(along.rail(), 0, track.gauge_depth);
        EXPECT_NEAR(extremes.top, 0, sampling) << x;
        EXPECT_NEAR(extremes.face, 0.5 * track.gauge, turned ? turned_sampling : sampling) << x;
      }
      // Between them the curve and its position are means. For upright heads, so are its top and its gauge face, up to
      // the error of cubic pieces where the side ends at a corner (section_blend_test.cpp). For turned heads, the
      // highest and the innermost points do not correspond exactly: 1:40 over 4 mm.
      along.moveTo(0.3);
      const Extremes extremes = extremesOf(along.rail(), 0, track.gauge_depth);
      EXPECT_NEAR(extremes.top, 0, turned ? 1e-4 : 1e-6);
      EXPECT_NEAR(extremes.face, 0.5 * track.gauge, turned ? 1e-4 : 1e-6);
    }
  }
}

TEST(RailAlong, CoordinatesKeepThePlaceRelativeToTheFirstSection)
{
  const TrackConfig track = upright();
  const RailSections sections({twoHeads({0.003, 0.002, 0.036}, {0.005, -0.004, 0.036})}, Placement::coordinates);
  RailAlong along(sections, track, Side::left);
  const Extremes first = extremesOf(along.rail(), 0, track.gauge_depth);
  EXPECT_NEAR(first.top, 0, sampling);
  EXPECT_NEAR(first.face, 0.5 * track.gauge, sampling);
  along.moveTo(1);
  const Extremes second = extremesOf(along.rail(), 0, track.gauge_depth);
  EXPECT_NEAR(second.top, -0.006, sampling);
  EXPECT_NEAR(second.face, 0.5 * track.gauge + 0.002, sampling);
  along.moveTo(0.25);
  const Extremes between = extremesOf(along.rail(), 0, track.gauge_depth);
  EXPECT_NEAR(between.top, -0.0015, sampling);
  EXPECT_NEAR(between.face, 0.5 * track.gauge + 0.0005, sampling);
}

TEST(RailAlong, FurtherPartsKeepTheirCoordinates)
{
  const TrackConfig track = upright();
  const RailSeries running = twoHeads({0, 0, 0.036}, {0.002, 0.001, 0.036});
  const RailSeries nose{{0, shared(profileOf({0.080, 0, 0.020})), {}}};
  const RailSections sections({running, nose}, Placement::coordinates);
  RailAlong along(sections, track, Side::right);
  along.moveTo(1);
  const Extremes rail = extremesOf(along.rail(), 0, track.gauge_depth),
                 further = extremesOf(along.rail(), 1, track.gauge_depth);
  // In the coordinates of the files, the nose begins 60 + 36 - 2 mm outside the gauge face of the rail, 1 mm lower.
  EXPECT_NEAR(further.face - rail.face, 0.094, sampling);
  EXPECT_NEAR(further.top - rail.top, -0.001, sampling);
}

// The gauge moves each section. Further parts would move with the wear of the running rail.
TEST(RailAlong, FurtherPartsBesideAChangingRailAreNotPlacedByTheGauge)
{
  const RailSeries running = twoHeads({0, 0, 0.036}, {0.002, 0.001, 0.036});
  const RailSeries nose{{0, shared(profileOf({0.080, 0, 0.020})), {}}};
  EXPECT_THROW(RailSections({running, nose}, Placement::gauge), std::invalid_argument);
}

TEST(RailAlong, MovesOnlyWhereTheRailChanges)
{
  const auto head = shared(profileOf({}));
  const RailSections sections({{{0, head, {}}, {1, head, {}}, {2, shared(profileOf({0.001})), {}}}}, Placement::gauge);
  RailAlong along(sections, TrackConfig(), Side::left);
  EXPECT_FALSE(along.moveTo(0.5));
  EXPECT_TRUE(along.moveTo(1.5));
  EXPECT_FALSE(along.moveTo(1.5));
  RailAlong constant(head, TrackConfig(), Side::left);
  EXPECT_FALSE(constant.moveTo(1.5));
}

TEST(RailAlong, PicturesShowTheRailOfTheCalculation)
{
  const RailSeries running = twoHeads({0, 0, 0.036}, {0.002, 0.001, 0.033});
  const RailSections by_gauge({running}, Placement::gauge);
  const RailSections by_coordinates({running, twoHeads({0.080, 0, 0.020}, {0.081, 0.001, 0.020})},
                                    Placement::coordinates);
  for (const RailSections* of_rail : {&by_gauge, &by_coordinates})
  {
    const RailSections& sections = *of_rail;
    RailAlong along(sections, TrackConfig(), Side::left);
    for (const double x : {0.0, 0.4, 1.0})
    {
      along.moveTo(x);
      expectSamePlace(railAt(sections, TrackConfig(), Side::left, x), along.rail());
    }
    // Outside, pictures show the nearest section.
    expectSamePlace(railAt(sections, TrackConfig(), Side::left, 7), along.rail());
  }
}

TEST(RailAlong, PicturesShowFurtherPartsBesideAConstantRail)
{
  const RailSections sections({{{0, shared(profileOf({})), {}}}, twoHeads({0.080}, {0.090})}, Placement::gauge);
  EXPECT_EQ(railAt(sections, TrackConfig(), Side::left, 0.5).profile().parts().size(), 2U);
  EXPECT_EQ(railAt(sections, TrackConfig(), Side::left, 1.5).profile().parts().size(), 1U);
  EXPECT_EQ(railAt(sections, TrackConfig(), Side::left, -0.5).profile().parts().size(), 1U);
}

TEST(RailAlong, ASectionThatEndsAboveTheGaugeDepthIsRefused)
{
  std::vector<ProfileSection> low;
  section_scenes::addHead({0, 0, 0.036, 0.004}, 0.006, 0.006, low);  // 10 mm deep
  const RailSeries series{{0, shared(profileOf({})), {}}, {1, shared({"low", low}), {}}};
  EXPECT_THROW(RailAlong(RailSections({series}, Placement::gauge), upright(), Side::left), std::invalid_argument);
  const RailSections free({series}, Placement::coordinates);
  EXPECT_NO_THROW(RailAlong(free, upright(), Side::left));
}

// Places of the rails on a line, measured on placed rails by the definitions of EN 13848-1.
constexpr double rail_rounding = 1e-15;  ///< rounding error of sums of lengths below 2 m [m]

/// Places of a rail in track axes, measured on the surface of its head.
struct RailMeasure
{
  double face = 0;   ///< y of the innermost point down to the gauge depth below the highest point [m]
  double top = 0;    ///< z of the highest point [m]
  double angle = 0;  ///< of the rail relative to its side axes [rad]: inclination minus outward roll
};

RailMeasure measured(const PlacedRail& rail, Side side, double gauge_depth)
{
  const Extremes extremes = extremesOf(rail, 0, gauge_depth);
  return {sideSign(side) * extremes.face, extremes.top, rail.angle()};
}

/// Both rails at one place of a line.
class RailOnLineTest : public testing::Test
{
 protected:
  /// Displacements of the gauge faces to the left, or of the rail tops upwards, by a station of a table.
  struct Case
  {
    const char *titles, *values;  ///< columns of the table, and their values [mm]
    double left, right;           ///< [mm]
  };

  /// Station of a table with the columns `titles` and the values `values`, all in mm.
  LineStation station(const std::string& titles, std::string values) const
  {
    std::replace(values.begin(), values.end(), ' ', ',');
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
    constexpr double tolerance = 1e-6;
    EXPECT_NEAR(rail_.left.face - 0.5 * scene_.track.gauge, left, tolerance);
    EXPECT_NEAR(rail_.right.face + 0.5 * scene_.track.gauge, right, tolerance);
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
    EXPECT_NEAR(rail_.left.angle - inclination, tilt, 1e-3 * std::abs(tilt) + rail_rounding);
    EXPECT_NEAR(rail_.right.angle - inclination, -tilt, 1e-3 * std::abs(tilt) + rail_rounding);
  }

  PlacedRail resting(Side side) const { return {scene_.rail_profile[side], scene_.track, side}; }
  PlacedRail placed(Side side) const { return resting(side).deflected(displaced_[side]); }

  static std::vector<std::string> split(const std::string& words)
  {
    std::istringstream stream(words);
    return {std::istream_iterator<std::string>(stream), {}};
  }

  const wheel_rail_contact::Folder folder_;
  ContactModelConfig scene_ = manchesterScene();
  Sides<RailDeflection> displaced_{};  ///< of each Side
  Sides<RailMeasure> rail_{};          ///< of each Side
};

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
    place(station(c.titles, c.values));
    expectFaces(1e-3 * c.left, 1e-3 * c.right);
    EXPECT_EQ(displaced_.left.roll, 0);
    EXPECT_EQ(displaced_.right.roll, 0);
  }
}

TEST_F(RailOnLineTest, LevelsAndCrossLevelAreThoseOfTheRailTops)
{
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
    place(station(c.titles, c.values));
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
      EXPECT_NEAR(placed(side).angle() - resting(side).angle(), angle, rail_rounding);
      for (double u = 0; u <= scene_.rail_profile[side]->length(); u += 0.01)
      {
        const PlanePoint before = resting(side).at(u), after = placed(side).at(u);
        EXPECT_NEAR(after.y, std::cos(angle) * before.y - std::sin(angle) * before.z, rail_rounding);
        EXPECT_NEAR(after.z, std::sin(angle) * before.y + std::cos(angle) * before.z, rail_rounding);
      }
    }
    const double height = placed(Side::left).referencePoint().z - placed(Side::right).referencePoint().z;
    EXPECT_NEAR(height, cross_level, rail_rounding);
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
      EXPECT_NEAR(after.y, std::cos(angle) * before.y - std::sin(angle) * before.z, rail_rounding);
      EXPECT_NEAR(after.z, std::sin(angle) * before.y + std::cos(angle) * before.z, rail_rounding);
    }
  }
}
}  // namespace
