// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "wheel_rail_contact/core/contact_geometry.h"

using namespace wheel_rail_contact::core;

namespace
{
using Curve = std::vector<RadiusDifference>;

constexpr double mm = 1e-3;

/// Curve of a radius difference [m] between -reach and reach [m], with a multiple of two steps.
template <typename Function>
Curve curveOf(Function difference, double reach, int steps)
{
  Curve curve;
  for (int i = 0; i <= steps; ++i)
  {
    const double y = reach * (2.0 * i / steps - 1);
    curve.push_back({y, difference(y)});
  }
  return curve;
}

/// Curve of equal wheels from points at y >= 0 [mm]; `shift` is the difference of their radii [mm].
Curve tabulated(const std::vector<std::pair<double, double>>& points, double shift = 0)
{
  Curve curve;
  for (auto point = points.rbegin(); point != points.rend(); ++point)
  {
    curve.push_back({-point->first * mm, (shift - point->second) * mm});
  }
  for (const auto& [y, difference] : points)
  {
    curve.push_back({y * mm, (shift + difference) * mm});
  }
  return curve;
}
}  // namespace

TEST(EquivalentConicity, OfConesIsTheirConicityAtEveryAmplitude)
{
  for (const int steps : {2, 60})
  {
    const Curve cones = curveOf([](double y) { return 2 * 0.05 * y; }, 10 * mm, steps);
    for (const double amplitude : {0.1 * mm, 1 * mm, 3.3 * mm, 9.9 * mm})
    {
      const EquivalentConicity found = equivalentConicity(cones, amplitude);
      EXPECT_NEAR(found.value, 0.05, 1e-9) << amplitude;
      EXPECT_NEAR(found.centre, 0, 1e-12) << amplitude;
    }
  }
}

TEST(EquivalentConicity, OfConesWithUnequalRadiiIsThatOfAWaveAboutAnotherCentre)
{
  const Curve cones = curveOf([](double y) { return 2 * 0.1 * y + 0.4 * mm; }, 10 * mm, 50);
  const EquivalentConicity found = equivalentConicity(cones, 3 * mm);
  EXPECT_NEAR(found.value, 0.1, 1e-9);
  EXPECT_NEAR(found.centre, -2 * mm, 1e-12);
}

// Closed form: S = d |y|, I = 2 ∫ dy / sqrt(d (A - y)) = 4 sqrt(A / d).
TEST(EquivalentConicity, OfAJumpInTheCentreFallsWithTheAmplitude)
{
  const double jump = 1 * mm;
  const Curve curve{{-10 * mm, -jump}, {0, -jump}, {0, jump}, {10 * mm, jump}};
  for (const double amplitude : {0.5 * mm, 2 * mm, 7 * mm})
  {
    EXPECT_NEAR(equivalentConicity(curve, amplitude).value, M_PI * M_PI * jump / (16 * amplitude), 1e-9) << amplitude;
  }
}

// Closed form: I = 4 L / (sqrt(k) A) with the lemniscate constant L = ∫ dx / sqrt(1 - x⁴), x = 0 to 1. The straight
// lines between 4000 points deviate from the cubic by 2e-7 of its largest value.
TEST(EquivalentConicity, OfACubicGrowsWithTheSquareOfTheAmplitude)
{
  const double factor = 1000;  // [1/m²]
  const double lemniscate = 1.3110287771461;
  const Curve cubic = curveOf([&](double y) { return factor * y * y * y; }, 8 * mm, 4000);
  for (const double amplitude : {4 * mm, 7.3 * mm})
  {
    const double integral = 4 * lemniscate / (std::sqrt(factor) * amplitude);
    const double exact = M_PI * M_PI / (integral * integral);
    EXPECT_NEAR(equivalentConicity(cubic, amplitude).value / exact, 1, 1e-5) << amplitude;
  }
}

// EN 15302:2008+A1:2010, annex E, wheels H on both sides (920 mm): radius difference at 0.1 mm steps, which are
// straight lines between these points; and the conicity. Tolerance: the figures have three decimals.
TEST(EquivalentConicity, AgreesWithTheStandardForWheelsWithAJump)
{
  const Curve curve = tabulated({{0, 0}, {2.5, 0.125}, {2.6, 2.407}, {6.7, 3.330}, {6.8, 11.216}});
  for (const auto& [amplitude, conicity] : std::vector<std::pair<double, double>>{{1.0, 0.025},
                                                                                  {2.0, 0.025},
                                                                                  {2.6, 0.075},
                                                                                  {2.7, 0.138},
                                                                                  {2.8, 0.184},
                                                                                  {3.0, 0.245},
                                                                                  {3.5, 0.308},
                                                                                  {4.0, 0.319},
                                                                                  {5.0, 0.306},
                                                                                  {6.0, 0.284},
                                                                                  {6.7, 0.270}})
  {
    EXPECT_NEAR(equivalentConicity(curve, amplitude * mm).value, conicity, 1e-3) << amplitude;
  }
}

// The same source, wheels B, 920 mm on the right and 918 mm on the left. Of the 0.1 mm steps, those are left out
// between which straight lines deviate by less than 0.01 mm.
TEST(EquivalentConicity, AgreesWithTheStandardForUnequalRadii)
{
  const Curve curve = tabulated({{0, 0},
                                 {2.9, 0.145},
                                 {3.0, 1.950},
                                 {3.5, 2.224},
                                 {4.0, 2.517},
                                 {4.5, 2.830},
                                 {5.0, 3.163},
                                 {5.5, 3.516},
                                 {6.0, 3.889},
                                 {6.3, 4.123}},
                                1);
  for (const auto& [amplitude, conicity] : std::vector<std::pair<double, double>>{
           {1.0, 0.660}, {1.5, 0.472}, {2.0, 0.376}, {2.5, 0.317}, {3.0, 0.278}, {3.5, 0.249}, {4.0, 0.227}})
  {
    EXPECT_NEAR(equivalentConicity(curve, amplitude * mm).value, conicity, 1e-3) << amplitude;
  }
}

TEST(EquivalentConicity, OfCylindersIsZero)
{
  const Curve cylinders = curveOf([](double y) { return 1e-8 * std::sin(9e3 * y); }, 10 * mm, 100);
  const EquivalentConicity found = equivalentConicity(cylinders, 3 * mm);
  EXPECT_EQ(found.status, ConicityStatus::ok);
  EXPECT_EQ(found.value, 0);
  EXPECT_EQ(kinematicWavelength(0, 1.5, 0.46), std::numeric_limits<double>::infinity());
}

TEST(EquivalentConicity, NeedsARadiusDifferenceThatGrowsThroughZero)
{
  const auto status = [](const Curve& curve) { return equivalentConicity(curve, 2 * mm).status; };
  EXPECT_EQ(status(curveOf([](double) { return 1 * mm; }, 10 * mm, 20)), ConicityStatus::no_centre);
  EXPECT_EQ(status(curveOf([](double y) { return -0.2 * y; }, 10 * mm, 20)), ConicityStatus::no_centre);
  EXPECT_EQ(status({}), ConicityStatus::no_centre);
}

TEST(EquivalentConicity, NeedsTheWholeWaveWithinTheRange)
{
  const Curve centred = curveOf([](double y) { return 0.2 * y; }, 3 * mm, 20);
  EXPECT_EQ(equivalentConicity(centred, 2.99 * mm).status, ConicityStatus::ok);
  EXPECT_EQ(equivalentConicity(centred, 3.01 * mm).status, ConicityStatus::out_of_range);
  const Curve shifted = curveOf([](double y) { return 0.2 * (y - 2 * mm); }, 3 * mm, 20);
  EXPECT_EQ(equivalentConicity(shifted, 0.99 * mm).status, ConicityStatus::ok);
  EXPECT_EQ(equivalentConicity(shifted, 1.01 * mm).status, ConicityStatus::out_of_range);
  EXPECT_TRUE(std::isnan(equivalentConicity(shifted, 1.01 * mm).value));
}

// dr = k (y³ - w² y): S has two minima, at ±w, and a maximum in the middle. With amplitudes up to w / sqrt(2) there is
// a wave about each minimum; above sqrt(2) w one about both.
TEST(EquivalentConicity, OfTwoCentresDependsOnTheAmplitude)
{
  const double w = 3 * mm;
  const Curve curve = curveOf([&](double y) { return 1000 * (y * y * y - w * w * y); }, 10 * mm, 2000);
  EXPECT_EQ(equivalentConicity(curve, 0.65 * w).status, ConicityStatus::several_waves);
  EXPECT_EQ(equivalentConicity(curve, 0.75 * w).status, ConicityStatus::no_wave);
  EXPECT_EQ(equivalentConicity(curve, 1.38 * w).status, ConicityStatus::no_wave);
  EXPECT_EQ(equivalentConicity(curve, 1.45 * w).status, ConicityStatus::ok);
}

TEST(EquivalentConicity, RefusesMisuse)
{
  const Curve cones = curveOf([](double y) { return 0.1 * y; }, 10 * mm, 4);
  EXPECT_THROW(equivalentConicity(cones, 0), std::invalid_argument);
  EXPECT_THROW(equivalentConicity(cones, std::nan("")), std::invalid_argument);
  EXPECT_THROW(equivalentConicity({{1, 0}, {0, 1}}, 0.1), std::invalid_argument);
}

// Klingel (1883): 2 pi sqrt(r b / gamma) with half the distance b.
TEST(KinematicWavelength, IsThatOfKlingel)
{
  EXPECT_NEAR(kinematicWavelength(0.025, 1.5, 0.46), 2 * M_PI * std::sqrt(0.46 * 0.75 / 0.025), 1e-12);
}
