// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "profile_helpers.h"
#include "wheel_rail_contact/core/standard_profiles.h"

namespace wheel_rail_contact::core
{
namespace
{
using test::mm;

/// Point of the profile at `y` [m]. y must increase along the curve.
CurvePoint atY(const Profile& profile, double y)
{
  return profile.at(test::parameterAt(profile, y));
}

/// Distance of a point from the profile [m], positive above it.
double height(const Profile& profile, double y, double z)
{
  double u = 0.0;
  double nearest = 1.0;
  for (int i = 0; i <= 2000; ++i)
  {
    const CurvePoint p = profile.at(profile.length() * i / 2000);
    if (std::hypot(p.y - y, p.z - z) < nearest)
    {
      nearest = std::hypot(p.y - y, p.z - z);
      u = profile.length() * i / 2000;
    }
  }
  for (int step = 0; step < 50; ++step)
  {
    const CurvePoint p = profile.at(u);
    u -= ((p.y - y) * p.dy + (p.z - z) * p.dz) / (p.dy * p.dy + p.dz * p.dz);
  }
  const CurvePoint p = profile.at(u);
  return ((z - p.z) * p.dy - (y - p.y) * p.dz) / std::hypot(p.dy, p.dz);
}

/// Boundary of two sections, in the direction from the flange back to the field side.
struct Discontinuity
{
  double y;            ///< [mm]
  double step;         ///< step of z [mm]
  double bend_before;  ///< d²z/dy² of the section before [1/mm]
  double bend_after;   ///< d²z/dy² of the section after [1/mm]
};

/// d²z/dy² [1/m].
double secondDerivative(const CurvePoint& p)
{
  return (p.ddz * p.dy - p.dz * p.ddy) / (p.dy * p.dy * p.dy);
}

/// Derivative by central differences of fourth order.
template <typename Value>
double difference(const Profile& profile, double u, const Value& value)
{
  const double h = 5e-5;
  const auto pair = [&](double step) { return value(profile.at(u + step)) - value(profile.at(u - step)); };
  return (8.0 * pair(h) - pair(2.0 * h)) / (12.0 * h);
}

void expectDerivativesByDifferences(const Profile& profile)
{
  for (std::size_t k = 0; k + 1 < profile.discontinuities().size(); ++k)
  {
    for (const double share : {0.1, 0.37, 0.5, 0.83})
    {
      const double u =
          profile.discontinuities()[k] + share * (profile.discontinuities()[k + 1] - profile.discontinuities()[k]);
      SCOPED_TRACE(u);
      const CurvePoint here = profile.at(u);
      // Truncation error of the differences: h⁴ / 30 times the fifth (sixth) derivative. The largest derivatives are
      // 1e10 1/m⁴ (5e12 1/m⁵), in section C of S1002.
      EXPECT_NEAR(here.dy, difference(profile, u, [](const CurvePoint& p) { return p.y; }), 5e-9);
      EXPECT_NEAR(here.dz, difference(profile, u, [](const CurvePoint& p) { return p.z; }), 5e-9);
      EXPECT_NEAR(here.ddy, difference(profile, u, [](const CurvePoint& p) { return p.dy; }), 2e-6);
      EXPECT_NEAR(here.ddz, difference(profile, u, [](const CurvePoint& p) { return p.dz; }), 2e-6);
    }
  }
}

TEST(S1002, ProfileRunsFromFlangeBackThroughRunningCircleToFieldSide)
{
  const Profile wheel = s1002Wheel();
  EXPECT_EQ(wheel.name(), "S1002");
  EXPECT_DOUBLE_EQ(wheel.at(0.0).y, -70.0 * mm);
  EXPECT_NEAR(wheel.at(wheel.length()).y, 60.0 * mm, 1e-16);
  EXPECT_NEAR(atY(wheel, 0.0).z, 0.0, 1e-17);
  EXPECT_EQ(wheel.discontinuities().size(), 9U);
}

TEST(S1002, FlangeHasTheDimensionsOfEn13715)
{
  const Profile wheel = s1002Wheel();
  // Flange height 28 mm: flange tip at y = -55 mm, where its arc is horizontal.
  EXPECT_NEAR(atY(wheel, -55.0 * mm).z, -28.0 * mm, 1e-16);
  // Flange thickness 32.5 mm: from the flange back at -70 mm, measured 10 mm below the running circle.
  EXPECT_NEAR(atY(wheel, -37.5 * mm).z, -10.0 * mm, 0.0005 * mm);
  // qR 10.794 mm: lateral distance between the point 2 mm above the tip and the point 10 mm below the running circle.
  double low = -55.0 * mm;
  double high = -40.0 * mm;
  for (int halving = 0; halving < 60; ++halving)
  {
    const double middle = 0.5 * (low + high);
    (atY(wheel, middle).z < -26.0 * mm ? low : high) = middle;
  }
  EXPECT_NEAR(-37.5 * mm - low, 10.794 * mm, 0.0006 * mm);
  // Flank angle 70 degrees.
  EXPECT_NEAR(std::atan(atY(wheel, -39.0 * mm).slope()) * 180.0 / 3.14159265358979323846, 70.0, 1e-6);
}

TEST(S1002, TreadHasThePolynomialsOfTheStandard)
{
  const Profile wheel = s1002Wheel();
  EXPECT_NEAR(atY(wheel, 0.0).slope(), 3.358537058e-2, 1e-15);
  EXPECT_NEAR(secondDerivative(atY(wheel, 0.0)), -2.0 * 1.565681624e-3 * 1e3, 1e-10);
  const double y = 20.0;
  const double down = -3.358537058e-2 * y + 1.565681624e-3 * y * y - 2.810427944e-5 * std::pow(y, 3) +
                      5.844240864e-8 * std::pow(y, 4) - 1.562379023e-8 * std::pow(y, 5) +
                      5.309217349e-15 * std::pow(y, 6) - 5.957839843e-12 * std::pow(y, 7) +
                      2.646656573e-13 * std::pow(y, 8);
  EXPECT_NEAR(atY(wheel, y * mm).z, -down * mm, 1e-17);
  EXPECT_NEAR(atY(wheel, 50.0 * mm).z, -(1.364323640 - 0.066666667 * 50.0) * mm, 1e-17);
}

TEST(S1002, SectionBoundariesHaveTheStepsAndCurvaturesOfTheStandard)
{
  // The values follow from the numbers of the standard alone. They were computed in rational arithmetic for the
  // polynomials, and as R² / (R² - (y - yc)²)^(3/2) for the arcs.
  const Discontinuity discontinuities[] = {{-62.764705882, 4.08e-10, 0.110060, 0.188019},
                                           {-49.662510381, -6.39e-8, 0.115992, 0.069595},
                                           {-39.764473993, 2.96e-8, 1.249726, 0.0},
                                           {-38.426669071, 2.04e-9, 0.0, -1.922656},
                                           {-35.0, 1.1833e-4, -0.1923071, -0.1923058},
                                           {-26.0, -3.6548e-5, -0.0210329, -0.0210335},
                                           {32.15796, 2.84e-10, 0.004172, 0.0}};
  const Profile wheel = s1002Wheel();
  for (std::size_t k = 0; k < 7; ++k)
  {
    SCOPED_TRACE(discontinuities[k].y);
    const double u = wheel.discontinuities()[k + 1];
    const CurvePoint before = wheel.at(std::nextafter(u, 0.0));
    const CurvePoint after = wheel.at(u);
    EXPECT_NEAR(after.y, discontinuities[k].y * mm, 1e-16);
    EXPECT_NEAR(before.y, discontinuities[k].y * mm, 1e-16);
    // The terms of the polynomials are up to 160 mm; their rounding error is 1e-16 m.
    EXPECT_NEAR(after.z - before.z, discontinuities[k].step * mm,
                0.005 * std::abs(discontinuities[k].step) * mm + 1e-15);
    EXPECT_NEAR(std::atan(after.slope()), std::atan(before.slope()), 5e-6);
    EXPECT_NEAR(secondDerivative(before), discontinuities[k].bend_before / mm, 6e-4);
    EXPECT_NEAR(secondDerivative(after), discontinuities[k].bend_after / mm, 6e-4);
  }
}

TEST(S1002, DerivativesAgreeWithDifferences)
{
  expectDerivativesByDifferences(s1002Wheel());
}

TEST(S1002, ProfilePassesThroughThePointsOfTheManchesterBenchmark)
{
  // Points of MBench_S1002_v3.prw (Manchester contact benchmark, Simpack format; y mirrored, z down), in mm. Near the
  // flange they are given to 1e-6 mm. The tolerance of 2e-6 mm is the rounding of the points and of the standard.
  const double points[][2] = {{-67.288396, 19.708615},  {-54.505121, 27.989791},   {-42.304446, 20.488738},
                              {-40.409365, 17.238210},  {-35.169732, 7.0260678},   {-26.211283, 2.7925449},
                              {-14.716500, 0.93792104}, {-1.2167753, 0.043234705}, {13.366072, -0.24128622},
                              {26.796290, -0.49095763}, {38.384643, -1.1946526},   {49.889591, -1.9616491},
                              {60.000000, -2.6356764}};
  const Profile wheel = s1002Wheel();
  for (const auto& point : points)
  {
    EXPECT_NEAR(atY(wheel, point[0] * mm).z, -point[1] * mm, 2e-6 * mm) << point[0];
  }
}

TEST(StandardProfiles, EachNameOfTheListsOpensTheProfileOfThatName)
{
  for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail})
  {
    const std::vector<std::string> names = standardProfileNames(kind);
    EXPECT_GE(names.size(), kind == ProfileKind::wheel ? 1U : 2U);
    for (const std::string& name : names)
    {
      EXPECT_EQ(loadProfile(name, kind).name(), name);
    }
  }
  EXPECT_EQ(standardProfileNames(ProfileKind::rail_section), standardProfileNames(ProfileKind::rail));
}

TEST(StandardProfiles, MessageOnAnUnknownNameListsAllOfThem)
{
  try
  {
    loadProfile("61E1", ProfileKind::rail);
    FAIL();
  }
  catch (const ProfileError& error)
  {
    for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail})
    {
      for (const std::string& name : standardProfileNames(kind))
      {
        EXPECT_NE(error.reason().find(name), std::string::npos) << name;
      }
    }
  }
}

/// Half-widths of the head at a depth below the crown [m]: on the gauge side and on the field side.
std::vector<double> halfWidths(const Profile& rail, double depth)
{
  std::vector<double> widths;
  for (const bool gauge_side : {true, false})
  {
    double side = gauge_side ? 0.0 : rail.length();
    double crown = 0.5 * rail.length();
    for (int halving = 0; halving < 60; ++halving)
    {
      const double middle = 0.5 * (side + crown);
      (rail.at(middle).z < -depth ? side : crown) = middle;
    }
    widths.push_back(std::abs(rail.at(side).y));
  }
  return widths;
}

void expectRailHead(const Profile& rail, double corner_step)
{
  const double bends[] = {0.0, -1.0 / 13, -1.0 / 80, -1.0 / 300, -1.0 / 80, -1.0 / 13, 0.0};
  ASSERT_EQ(rail.discontinuities().size(), 8U);
  for (std::size_t k = 0; k < 7; ++k)
  {
    const double start = rail.discontinuities()[k];
    const double end = rail.discontinuities()[k + 1];
    for (const double share : {0.0, 0.3, 0.7})
    {
      EXPECT_NEAR(rail.at(start + share * (end - start)).curvature(), bends[k] / mm, 1e-10);
    }
    const CurvePoint before = rail.at(std::nextafter(start, 0.0));
    const CurvePoint after = rail.at(start);
    const double step = k == 2 || k == 5 ? corner_step : 0.0;
    EXPECT_NEAR(std::hypot(after.y - before.y, after.z - before.z), k == 0 ? 0.0 : step, 1e-12);
    EXPECT_NEAR(std::atan(after.slope()), std::atan(before.slope()), 1e-12);
  }
  for (int i = 0; i <= 200; ++i)
  {
    const double u = rail.length() * i / 200;
    const CurvePoint left = rail.at(u);
    const CurvePoint right = rail.at(rail.length() - u);
    EXPECT_NEAR(left.y, -right.y, 1e-16);
    EXPECT_NEAR(left.z, right.z, 1e-16);
    EXPECT_NEAR(left.dz, -right.dz, 1e-14);
  }
  EXPECT_NEAR(rail.at(0.5 * rail.length()).z, 0.0, 1e-16);
  EXPECT_NEAR(rail.at(0.0).slope(), 20.0, 1e-12);
}

TEST(Rail60E1, HeadHasTheDimensionsOfEn13674)
{
  const Profile rail = rail60E1();
  EXPECT_EQ(rail.name(), "60E1");
  expectRailHead(rail, 0.0);
  const std::vector<double>& discontinuities = rail.discontinuities();
  // Widths from the drawing of the standard, 20.456 and 52.053 mm. Depths from the tangency of the arcs.
  EXPECT_NEAR(rail.at(discontinuities[4]).y, 20.456 / 2 * mm, 1e-16);
  EXPECT_NEAR(rail.at(discontinuities[4]).z, -0.174404 * mm, 1e-9);
  EXPECT_NEAR(rail.at(discontinuities[5]).y, 52.053 / 2 * mm, 1e-16);
  EXPECT_NEAR(rail.at(discontinuities[5]).z, -2.302524 * mm, 1e-9);
  EXPECT_NEAR(rail.at(discontinuities[6]).y, 35.999811 * mm, 1e-9);
  EXPECT_NEAR(rail.at(discontinuities[6]).z, -14.299958 * mm, 1e-9);
  for (const double half_width : halfWidths(rail, 14.3 * mm))
  {
    EXPECT_NEAR(half_width, 35.9998 * mm, 0.00005 * mm);
  }
  expectDerivativesByDifferences(rail);
}

TEST(RailUic60Manchester, HeadHasTheDimensionsOfTheBenchmark)
{
  const Profile rail = railUic60Manchester();
  EXPECT_EQ(rail.name(), "UIC60_manchester");
  // The centre of R13, fitted to the sampled points 14.908972 mm below the crown, is closer to that of R80 than
  // tangency requires. The difference is the step.
  const double corner_yc = 36.0 - 13.0 * 20.0 / std::sqrt(401.0);
  const double shoulder_zc = 300.0 - 220.0 / 300.0 * std::sqrt(300.0 * 300.0 - 10.5 * 10.5);
  const double step = 67.0 - std::hypot(corner_yc - 7.7, shoulder_zc - 14.908972);
  EXPECT_NEAR(step, 4.4e-5, 1e-6);
  expectRailHead(rail, step * mm);
  const std::vector<double>& discontinuities = rail.discontinuities();
  EXPECT_NEAR(rail.at(discontinuities[4]).y, 10.5 * mm, 1e-16);
  EXPECT_NEAR(rail.at(discontinuities[4]).z, -0.183806 * mm, 1e-9);
  EXPECT_NEAR(rail.at(discontinuities[6]).y, 36.0 * mm, 1e-16);
  for (const double half_width : halfWidths(rail, 14.3 * mm))
  {
    EXPECT_NEAR(half_width, 36.0020 * mm, 0.00005 * mm);
  }
  expectDerivativesByDifferences(rail);
}

TEST(RailUic60Manchester, HeadDiffersFromEn13674AtTheGaugeCorner)
{
  const Profile other = railUic60Manchester();
  const Profile rail = rail60E1();
  double largest = 0.0;
  for (int i = 0; i <= 400; ++i)
  {
    const CurvePoint p = other.at(other.length() * i / 400);
    if (p.z > -15.0 * mm)
    {
      largest = std::max(largest, std::abs(height(rail, p.y, p.z)));
    }
  }
  EXPECT_NEAR(largest, 0.040 * mm, 0.002 * mm);
}

TEST(RailUic60Manchester, ProfilePassesThroughThePointsOfTheManchesterBenchmark)
{
  // Points of MBench_UIC60_v3.prr (Manchester contact benchmark, Simpack format; z down), in mm: inclined 1:40 with the
  // crown at (-7.4917, 0.0937). This position is given to 4 digits. It is 6e-6 mm from the crown that fits the points
  // best.
  const double points[][2] = {{-43.704898, 38.510726}, {-43.677901, 37.429500}, {-43.341847, 23.970535},
                              {-43.08906, 14.566214},  {-41.139292, 8.6628082}, {-35.148935, 3.5819400},
                              {-33.656069, 3.0611091}, {-24.189524, 1.1561780}, {-7.7252199, 0.099634970},
                              {8.9005890, 0.29140679}, {20.097329, 2.1224756},  {26.437748, 6.8238663},
                              {29.455887, 21.471886},  {30.595907, 36.653155}};
  const Profile rail = railUic60Manchester();
  const double c = std::cos(std::atan(1.0 / 40));
  const double s = std::sin(std::atan(1.0 / 40));
  for (const auto& point : points)
  {
    const double y = (point[0] + 7.4917) * mm;
    const double z = -(point[1] - 0.0937) * mm;
    EXPECT_NEAR(height(rail, c * y + s * z, -s * y + c * z), 0.0, 1e-5 * mm) << point[0];
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
