// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/pressure_scale.h"

#include <gtest/gtest.h>

#include "result_scene.h"

using namespace wheel_rail_contact;

namespace
{
const ros::Time begin(100);

ros::Time after(double seconds)
{
  return begin + ros::Duration(seconds);
}
}  // namespace

TEST(PressureScale, FixedUpperEndIgnoresThePressure)
{
  PressureScale scale(2e9);
  EXPECT_EQ(scale.update(begin, 7e9), 2e9);
  EXPECT_EQ(scale.update(after(10), 1e6), 2e9);
}

TEST(PressureScale, FollowsInPowersOfTwo)
{
  for (const auto& [highest, upper] : std::vector<std::pair<double, double>>{
           {0.3e9, 0.5e9}, {0.7e9, 1e9}, {1e9, 1e9}, {1.001e9, 2e9}, {2.4e9, 4e9}, {6.757e9, 8e9}})
  {
    EXPECT_DOUBLE_EQ(PressureScale(0).update(begin, highest), upper) << highest;
  }
}

TEST(PressureScale, RisesAtOnceAndFallsAfterTwoSeconds)
{
  PressureScale scale(0);
  EXPECT_EQ(scale.update(begin, 0.9e9), 1e9);
  EXPECT_EQ(scale.update(after(0.1), 3e9), 4e9);
  EXPECT_EQ(scale.update(after(0.2), 0.9e9), 4e9);
  EXPECT_EQ(scale.update(after(2.0), 0.9e9), 4e9);
  EXPECT_EQ(scale.update(after(2.2), 0.9e9), 1e9);
}

TEST(PressureScale, PressureAroundAStepDoesNotChangeItBackAndForth)
{
  PressureScale scale(0);
  scale.update(begin, 2.01e9);
  for (int i = 1; i < 100; ++i)
  {
    EXPECT_EQ(scale.update(after(0.1 * i), i % 2 == 0 ? 2.01e9 : 1.99e9), 4e9);
  }
}

TEST(PressureScale, ResultWithoutPatchesKeepsIt)
{
  PressureScale scale(0);
  EXPECT_EQ(scale.update(begin, 0), 1e9) << "before the first pressure";
  scale.update(after(1), 3e9);
  EXPECT_EQ(scale.update(after(20), 0), 4e9);
}

TEST(PressureScale, TimeThatGoesBackRestartsIt)
{
  PressureScale scale(0);
  scale.update(begin, 3e9);
  EXPECT_EQ(scale.update(after(-1), 0.9e9), 1e9);
}

TEST(PressureScale, NoPressureAndTinyPressuresGiveAFinitePositiveScale)
{
  PressureScale scale(0);
  const double upper = scale.update(begin, 1e-300);
  EXPECT_GT(upper, 0);
  EXPECT_LT(upper, 3e6);
}

using HighestPressure = ResultScene;

TEST_F(HighestPressure, IsThatOfTheDrawnSidesAndOfTheirCells)
{
  result.patches[0].max_pressure = 3e9;
  result.patches[1].pressure(3, 3) = 4e9;
  EXPECT_EQ(highestPressure(output, {core::Side::left}), 3e9);
  EXPECT_EQ(highestPressure(output, {core::Side::right}), 4e9);
  EXPECT_EQ(highestPressure(output, {core::Side::left, core::Side::right}), 4e9);
  output.result = nullptr;
  EXPECT_EQ(highestPressure(output, {core::Side::left}), 0);
}
