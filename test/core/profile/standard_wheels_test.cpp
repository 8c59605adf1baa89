// SPDX-License-Identifier: BSD-3-Clause
#include "standard_helpers.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Boundary of two sections, in the direction from the flange back to the field side.
struct Discontinuity
{
  double y;            ///< [mm]
  double step;         ///< step of z [mm]
  double bend_before;  ///< d²z/dy² of the section before [1/mm]
  double bend_after;   ///< d²z/dy² of the section after [1/mm]
};

TEST(S1002, ProfileRunsFromFlangeBackThroughRunningCircleToFieldSide)
{
  const Profile wheel = s1002Wheel();
  EXPECT_EQ(wheel.name(), "S1002");
  EXPECT_DOUBLE_EQ(wheel.at(0.0).y, -70.0 * mm);
  EXPECT_NEAR(wheel.at(wheel.length()).y, 60.0 * mm, 1e-16);
  EXPECT_NEAR(atY(wheel, 0.0).z, 0.0, 1e-17);
  EXPECT_EQ(wheel.discontinuities().size(), 9U);
  expectDerivativesByDifferences(wheel);
}

TEST(S1002, FlangeHasTheDimensionsOfEn13715)
{
  const Profile wheel = s1002Wheel();
  // Flange height 28 mm: flange tip at y = -55 mm, where its arc is horizontal.
  EXPECT_NEAR(atY(wheel, -55.0 * mm).z, -28.0 * mm, 1e-16);
  // Flange thickness 32.5 mm: from the flange back at -70 mm, measured 10 mm below the running circle.
  EXPECT_NEAR(atY(wheel, -37.5 * mm).z, -10.0 * mm, 0.0005 * mm);
  // qR 10.794 mm: lateral distance between the point 2 mm above the tip and the point 10 mm below the running circle.
  const double upper = lastWhere([&](double y) { return atY(wheel, y).z < -26.0 * mm; }, -55.0 * mm, -40.0 * mm);
  EXPECT_NEAR(-37.5 * mm - upper, 10.794 * mm, 0.0006 * mm);
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

/// Checks that the sections of a wheel join without step, and without kink except at y = `kink` [mm].
void expectSmoothJoints(const Profile& wheel, double step, double turn, double kink)
{
  for (std::size_t k = 1; k + 1 < wheel.discontinuities().size(); ++k)
  {
    const double u = wheel.discontinuities()[k];
    const CurvePoint before = wheel.at(std::nextafter(u, 0.0));
    const CurvePoint after = wheel.at(u);
    SCOPED_TRACE(after.y / mm);
    EXPECT_LT(std::hypot(after.y - before.y, after.z - before.z), step);
    if (std::abs(after.y - kink * mm) > 1e-9)
    {
      EXPECT_NEAR(std::atan(after.slope()), std::atan(before.slope()), turn);
    }
  }
}

TEST(LmaWheel, SectionsAreTheArcsAndConesOfLma)
{
  const Profile wheel = lmaWheel();
  EXPECT_EQ(wheel.name(), "LMA");
  EXPECT_DOUBLE_EQ(wheel.at(0.0).y, -70.0 * mm);
  EXPECT_NEAR(wheel.at(wheel.length()).y, 60.0 * mm, 1e-16);
  const double bends[] = {1.0 / 25, 1.0 / 12, 1.0 / 15, 0.0, -1.0 / 14, -1.0 / 90, -1.0 / 450, 0.0, 0.0};
  ASSERT_EQ(wheel.discontinuities().size(), 10U);
  for (std::size_t k = 0; k < 9; ++k)
  {
    const double u = 0.5 * (wheel.discontinuities()[k] + wheel.discontinuities()[k + 1]);
    EXPECT_NEAR(wheel.at(u).curvature(), bends[k] / mm, 1e-10) << k;
  }
  expectSmoothJoints(wheel, 1e-15, 1e-12, 30.0);
  expectDerivativesByDifferences(wheel);
}

TEST(LmaWheel, FlangeAndTreadHaveTheirDimensions)
{
  const Profile wheel = lmaWheel();
  EXPECT_NEAR(atY(wheel, -54.0 * mm).z, -28.0 * mm, 1e-16) << "flange height";
  EXPECT_NEAR(atY(wheel, 0.0).z, 0.0, 1e-16) << "running circle";
  EXPECT_NEAR(std::atan(atY(wheel, -39.0 * mm).slope()) * 180.0 / std::acos(-1.0), 70.0, 1e-9) << "flank";
  EXPECT_NEAR(atY(wheel, 0.0).slope(), 15.5 / std::sqrt(450.0 * 450.0 - 15.5 * 15.5), 1e-12);
  EXPECT_NEAR(atY(wheel, 20.0 * mm).slope(), 1.0 / 40, 1e-14);
  EXPECT_NEAR(atY(wheel, 45.0 * mm).slope(), 1.0 / 15, 1e-14);
}

/// Largest distance in height of a wheel from points [mm] with z down.
template <std::size_t Count>
double largestOffset(const Profile& wheel, const double (&points)[Count][2])
{
  double largest = 0.0;
  for (const auto& point : points)
  {
    const CurvePoint p = atY(wheel, point[0] * mm);
    largest = std::max(largest, std::abs(p.z + point[1] * mm) * std::abs(p.dy) / std::hypot(p.dy, p.dz));
  }
  return largest;
}

TEST(LmaWheel, ProfilePassesThroughThePointsOfTheDatasets)
{
  // LMA.txt of the Wheel-Rail-Interaction-Dataset (Legend19960404).
  const double exact[][2] = {
      {-69, 13.619168}, {-66, 20.183828},  {-63, 23.96852},  {-60, 26.392305}, {-54, 28},         {-50, 27.373924},
      {-46, 25.475649}, {-42, 21.519649},  {-40, 17.423242}, {-39, 14.675766}, {-38, 11.930754},  {-36, 8.3344896},
      {-33, 5.4459591}, {-30, 3.8260334},  {-28, 3.2038729}, {-20, 1.5217336}, {-12, 0.58102738}, {-8, 0.34700636},
      {-2, 0.07338286}, {3, -0.093379053}, {5, -0.1451267},  {20, -0.5201267}, {29, -0.7451267},  {31, -0.83679337},
      {45, -1.7701267}, {59, -2.70346}};
  EXPECT_LT(largestOffset(lmaWheel(), exact), 1e-6 * mm);
  // LMA.prw of JBG_SDITT (zzh158shallow-tech), with points to 1 um: tread and flange tip agree, ...
  const double rounded[][2] = {
      {-68.0, 16.4177},  {-64.0, 22.867},   {-60.0, 26.392},   {-54.0, 28.0001},  {-30.0, 3.82707}, {-28.0, 3.20087},
      {-24.0, 2.26511},  {-18.0, 1.21592},  {-12.0, 0.57807},  {-6.0, 0.244129},  {0.0, -0.00287},  {4.0, -0.122976},
      {10.0, -0.269892}, {20.0, -0.519892}, {28.0, -0.719891}, {32.0, -0.902998}, {45.0, -1.76993}, {58.0, -2.63603}};
  EXPECT_LT(largestOffset(lmaWheel(), rounded), 0.0035 * mm);
  // ... but its flank is 24 um closer to the field side.
  const double flank[][2] = {{-40.0, 17.4947}, {-39.5, 16.1209}, {-39.0, 14.7472}, {-38.5, 13.3723}};
  EXPECT_NEAR(largestOffset(lmaWheel(), flank), 0.024 * mm, 0.001 * mm);
}

TEST(ConeWheel, TreadIsStraightAndFlangeIsThatOfEn13715)
{
  const Profile s1002 = s1002Wheel();
  for (const double slope : {1.0 / 20, 1.0 / 40})
  {
    SCOPED_TRACE(slope);
    const Profile wheel = coneWheel(slope);
    for (const double y : {-69.0, -60.0, -55.0, -50.0, -42.0, -39.0})
    {
      EXPECT_NEAR(atY(wheel, y * mm).z, atY(s1002, y * mm).z, 1e-15) << y;
    }
    for (const double y : {-26.0 + 1.0, 0.0, 30.0, 60.0})
    {
      EXPECT_NEAR(atY(wheel, y * mm).z, slope * y * mm, 1e-16) << y;
      EXPECT_NEAR(atY(wheel, y * mm).slope(), slope, 1e-14) << y;
    }
    EXPECT_NEAR(atY(wheel, -30.0 * mm).curvature(), -1.0 / 13 / mm, 1e-10);
    EXPECT_NEAR(atY(wheel, (32.301 - 70.0) * mm).z, -10.0 * mm, 0.001 * mm) << "flange thickness";
    // Flange sections: rounded numbers of the standard, as in S1002. The steps there are 0.06 nm, the kinks 7e-10.
    expectSmoothJoints(wheel, 1e-10, 1e-9, 1e9);
    expectDerivativesByDifferences(wheel);
  }
  EXPECT_EQ(coneWheel(1.0 / 20).name(), "cone_1_20");
  EXPECT_EQ(coneWheel(1.0 / 40).name(), "cone_1_40");
}

TEST(ConeWheel, OtherSlopesAreRefusedByName)
{
  for (const double slope : {-0.05, 0.0, 0.2, std::nan("")})
  {
    EXPECT_THROW(coneWheel(slope), std::invalid_argument) << slope;
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
