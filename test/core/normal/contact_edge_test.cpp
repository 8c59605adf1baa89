// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/contact_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace wheel_rail_contact::core
{
namespace
{
double areaOf(const Eigen::ArrayXXd& pressure, double aspect, bool mirrored = false)
{
  EdgePolygon polygon;
  polygon.frame(pressure, mirrored);
  return polygon.cells(aspect);
}

/// Root of a paraboloid whose axes are oblique to the cells and off their middle.
Eigen::ArrayXXd askewPressure(std::mt19937& random)
{
  std::uniform_real_distribution<double> part(-1, 1);
  const double slope = 0.3 * part(random), x0 = part(random), y0 = part(random);
  Eigen::ArrayXXd pressure(16, 30);
  for (int j = 0; j < pressure.cols(); ++j)
  {
    for (int i = 0; i < pressure.rows(); ++i)
    {
      const double x = (i - 7.5 + x0) / 6, y = (j - 14.5 + y0) / 11;
      pressure(i, j) = std::sqrt(std::max(1 - x * x - y * y - slope * x * y, 0.0));
    }
  }
  return pressure;
}

TEST(ContactEdge, AreaIsIndependentOfOrientationAndScale)
{
  constexpr unsigned seed = 5;
  constexpr double aspect = 2.3, tolerance = 1e-5;  // sums in single precision [cells]
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k)
  {
    const Eigen::ArrayXXd pressure = askewPressure(random);
    const double area = areaOf(pressure, aspect);
    EXPECT_GT(area, 150);
    EXPECT_NEAR(areaOf(pressure.colwise().reverse(), aspect), area, tolerance);
    EXPECT_NEAR(areaOf(pressure.rowwise().reverse(), aspect), area, tolerance);
    EXPECT_NEAR(areaOf(pressure.transpose(), 1 / aspect), area, tolerance);
    EXPECT_NEAR(areaOf(1e9 * pressure, aspect), area, tolerance);
  }
}

TEST(ContactEdge, AreaOfAStoredHalfIsHalfOfTheWhole)
{
  constexpr unsigned seed = 6;
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k)
  {
    const Eigen::ArrayXXd half = askewPressure(random).bottomRows(9);
    Eigen::ArrayXXd whole(18, half.cols());
    whole << half.colwise().reverse(), half;
    EXPECT_NEAR(2 * areaOf(half, 1.7, true), areaOf(whole, 1.7), 1e-5);
  }
}

/// Number of islands of a pressure minus the number of holes.
int islandsOf(const Eigen::ArrayXXd& pressure, bool mirrored = false)
{
  EdgePolygon polygon;
  polygon.frame(pressure, mirrored);
  polygon.chords();
  return polygon.islands();
}

TEST(ContactEdge, TwoIslandsHaveTwiceTheAreaOfOne)
{
  constexpr unsigned seed = 8;
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k)
  {
    const Eigen::ArrayXXd one = askewPressure(random);
    Eigen::ArrayXXd beside(one.rows(), 2 * one.cols()), behind(2 * one.rows(), one.cols());
    beside << one, one;
    behind << one.colwise().reverse(), one;
    EXPECT_EQ(islandsOf(one), 1);
    EXPECT_EQ(islandsOf(beside), 2);
    EXPECT_EQ(islandsOf(behind), 2);
    EXPECT_EQ(islandsOf(one, true), 2);
    EXPECT_NEAR(areaOf(beside, 1.4), 2 * areaOf(one, 1.4), 1e-4);
    EXPECT_NEAR(areaOf(behind, 1.4), 2 * areaOf(one, 1.4), 1e-4);
    EXPECT_NEAR(areaOf(one, 1.4, true), areaOf(one, 1.4), 1e-4);
  }
}

TEST(ContactEdge, AHoleIsSubtractedFromTheIslands)
{
  Eigen::ArrayXXd pressure = Eigen::ArrayXXd::Zero(12, 16);
  pressure.block(2, 3, 8, 9) = 1;
  pressure.block(5, 6, 3, 3) = 0;
  EXPECT_EQ(islandsOf(pressure), 0);
  pressure(6, 7) = 1;
  EXPECT_EQ(islandsOf(pressure), 1);
  pressure(5, 6) = 1;  // touches the ring; touches the cell in its middle only at a corner
  EXPECT_EQ(islandsOf(pressure), 1);
}

// A barely loaded cell near a much higher island, with an empty cell between them. Without a limit for the relative
// pressures at a crossing, the area error would be the ratio of the two pressures.
TEST(ContactEdge, ABarelyLoadedCellNearAnIslandHardlyChangesTheArea)
{
  Eigen::ArrayXXd pressure = Eigen::ArrayXXd::Zero(12, 16);
  pressure.block(4, 6, 4, 4) = 1;
  const double alone = areaOf(pressure, 1);
  pressure(2, 7) = 1e-7;
  EXPECT_NEAR(areaOf(pressure, 1), alone, 2);
}

// Every cell of a line is at the edge, and the next line is empty.
TEST(ContactEdge, StripesOfSingleColumnsKeepTheirArea)
{
  Eigen::ArrayXXd pressure = Eigen::ArrayXXd::Zero(12, 40);
  for (int j = 2; j < 38; j += 2)
  {
    pressure.col(j).segment(2, 8) = 1;
  }
  EdgePolygon polygon;
  polygon.frame(pressure, false);
  const double chords = polygon.chords();
  EXPECT_GE(polygon.cells(1), 0.5 * chords);
  EXPECT_LE(polygon.cells(1), 2 * chords);
}

TEST(ContactEdge, NoPressureHasNoArea)
{
  EXPECT_EQ(areaOf(Eigen::ArrayXXd::Zero(12, 16), 1), 0);
}

TEST(ContactEdge, EachLineIsCrossedWhereItsPressureBeginsAndEnds)
{
  Eigen::ArrayXXd pressure = Eigen::ArrayXXd::Zero(12, 16);
  pressure.block(4, 6, 3, 5) = 1;
  EdgePolygon polygon;
  polygon.frame(pressure, false);
  EXPECT_GT(polygon.chords(), 0);
  EXPECT_EQ(polygon.crossings().size(), 2U * (3 + 5));
}
}  // namespace
}  // namespace wheel_rail_contact::core
