// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/curve/measures.h"

#include "profile_helpers.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Polygon through points [mm], as a profile of straight sections.
Profile polygon(const std::vector<Point>& points)
{
  std::vector<ProfileSection> sections;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const double dy = points[i + 1].y - points[i].y, dz = points[i + 1].z - points[i].z;
    const double length = std::hypot(dy, dz);
    sections.push_back({LineSection{points[i].y * mm, points[i].z * mm, dy / length, dz / length}, length * mm});
  }
  return {"polygon", sections};
}

/// Rail head with sides of these slopes (horizontal over vertical), 70 mm wide at the top, inclined by an angle.
Profile headWithSides(double gauge_slope, double field_slope, double inclination)
{
  constexpr double height = 35;
  std::vector<Point> points{
      {-35 - gauge_slope * height, -height}, {-35, 0}, {0, 0.5}, {35, 0}, {35 + field_slope * height, -height}};
  for (Point& p : points)
  {
    p = {std::cos(inclination) * p.y - std::sin(inclination) * p.z,
         std::sin(inclination) * p.y + std::cos(inclination) * p.z};
  }
  return polygon(points);
}
}  // namespace

// EN 13715: flange height 28 mm, flange thickness 32.5 mm. The upper point of qR is on the arc R20 (section F), 26 mm
// below the running circle.
TEST(WheelMeasures, OfS1002AreThoseOfTheStandard)
{
  const WheelMeasures measures = wheelMeasures(s1002Wheel());
  EXPECT_NEAR(measures.flange_height / mm, 28.0, 1e-4);
  EXPECT_NEAR(*measures.flange_thickness / mm, 32.5, 1e-3);
  const double upper = -58.558326413 + std::sqrt(20.0 * 20.0 - std::pow(26 - 8.834924130, 2));
  EXPECT_NEAR(measures.upper->y / mm, upper, 1e-4);
  EXPECT_NEAR(*measures.flange_gradient / mm, -37.5 - upper, 1e-3);
  EXPECT_NEAR(measures.running_circle.y, 0, 1e-12);
}

// Straight flanks: all points by hand.
TEST(WheelMeasures, OfAPolygonAreExact)
{
  const Profile wheel = polygon({{-70, -20}, {-55, -30}, {-40, -15}, {-30, 0.5}, {60, 1}});
  const WheelMeasures measures = wheelMeasures(wheel);
  const double circle = 0.5 + 0.5 / 3;  // on the tread at y = 0
  EXPECT_NEAR(measures.flange_height / mm, 30 + circle, 1e-9);
  const double front = -40 + (circle - 10 + 15) * 10 / 15.5;
  EXPECT_NEAR(*measures.flange_thickness / mm, 70 + front, 1e-9);
  EXPECT_NEAR(*measures.flange_gradient / mm, front + 53, 1e-9);
}

TEST(WheelMeasures, OfAFlangeWithoutFrontAreEmpty)
{
  const WheelMeasures measures = wheelMeasures(polygon({{-60, -14}, {-55, -15}, {-50, -6}, {40, 1}}));
  EXPECT_TRUE(measures.front);
  EXPECT_TRUE(measures.upper);
  const WheelMeasures low = wheelMeasures(polygon({{-60, -4}, {-55, -9}, {-50, -6}, {40, 1}}));
  EXPECT_FALSE(low.flange_thickness);
  EXPECT_FALSE(low.flange_gradient);
}

TEST(RailMeasures, OfAPolygonAreExact)
{
  const RailMeasures measures = railMeasures(headWithSides(0.05, 0.1, 0));
  EXPECT_NEAR(measures.top.y, 0, 1e-9);
  EXPECT_NEAR(measures.top.z / mm, 0.5, 1e-9);
  EXPECT_NEAR(measures.gauge_side->y / mm, -35 - 0.05 * 13.5, 1e-9);
  EXPECT_NEAR(measures.gauge_point->y, measures.gauge_side->y, 1e-12);
  EXPECT_NEAR(*measures.head_width / mm, 70 + 0.15 * 13.5, 1e-9);
  EXPECT_NEAR(*measures.gauge_side_lean, std::atan(0.05), 1e-9);
  EXPECT_NEAR(*measures.field_side_lean, -std::atan(0.1), 1e-9);
}

// The gauge side hangs over: its innermost point is not at the depth of 14 mm.
TEST(RailMeasures, GaugePointIsTheInnermostOneAboveItsDepth)
{
  const RailMeasures measures = railMeasures(headWithSides(-0.1, 0.05, 0));
  EXPECT_NEAR(measures.gauge_point->y / mm, -35, 1e-6);
  EXPECT_NEAR(measures.gauge_side->y / mm, -35 + 0.1 * 13.5, 1e-9);
}

TEST(RailMeasures, InclinationIsThatOfTheAxisBetweenTheSides)
{
  for (const double inclination : {-0.05, 0.0, 0.025})
  {
    const RailMeasures measures = railMeasures(headWithSides(0.05, 0.05, inclination));
    ASSERT_TRUE(measures.inclination());
    EXPECT_NEAR(*measures.inclination(), inclination, 1e-9);
  }
  EXPECT_NEAR(*railMeasures(rail60E1()).inclination(), 0, 1e-9);
}

TEST(RailMeasures, OfSidesThatEndOrBendAreEmpty)
{
  const RailMeasures cut = railMeasures(polygon({{-36, -20.5}, {-35, 0}, {0, 0.5}, {35, 0}, {36, -40}}));
  EXPECT_TRUE(cut.head_width);
  EXPECT_FALSE(cut.gauge_side_lean);
  EXPECT_TRUE(cut.field_side_lean);
  const RailMeasures bent =
      railMeasures(polygon({{-38, -40}, {-36, -21.5}, {-35, 0}, {0, 0.5}, {35, 0}, {30, -21.5}, {36, -40}}));
  EXPECT_FALSE(bent.field_side_lean);
  const RailMeasures flat = railMeasures(polygon({{-36, -9}, {-35, 0}, {0, 0.5}, {35, 0}, {36, -40}}));
  EXPECT_FALSE(flat.gauge_point);
  EXPECT_FALSE(flat.head_width);
}

TEST(RunningSurface, EndsAtTheTipOfTheFlangeAndBelowTheHead)
{
  const Profile wheel = s1002Wheel(), rail = rail60E1();
  EXPECT_NEAR(wheel.at(runningSurface(wheel, ProfileKind::wheel).begin).z / mm, -28, 1e-4);
  EXPECT_EQ(runningSurface(wheel, ProfileKind::wheel).end, wheel.length());
  const ParameterRange range = runningSurface(rail, ProfileKind::rail);
  EXPECT_NEAR(rail.at(range.begin).z / mm, -14, 1e-9);
  EXPECT_NEAR(rail.at(range.end).z / mm, -14, 1e-9);
}
