// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "../../manchester_scene.h"
#include "../normal/problems.h"
#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double lowest = 2e-5;  ///< [m]

/// A paraboloid on a grid [m].
Eigen::ArrayXXd paraboloid(const Grid& grid, double x0, double y0)
{
  Eigen::ArrayXXd gap(grid.rows(), grid.ny);
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.rows(); ++i)
    {
      const double x = grid.x(i) - x0, y = grid.y(j) - y0;
      gap(i, j) = lowest + 1.1 * x * x + 40 * y * y;
    }
  }
  return gap;
}

TEST(LeastGap, IsTheVertexOfAParaboloidAtAnyPositionBetweenTheCells)
{
  constexpr unsigned long seed = 17;
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  for (int k = 0; k < 100; ++k)
  {
    for (const bool symmetric : {true, false})
    {
      const Grid grid = problems::centredGrid(8, 9, 8e-3, 4e-3, symmetric);
      const double x0 = symmetric ? 0 : problems::uniform(random, -2e-3, 2e-3);
      const Eigen::ArrayXXd gap = paraboloid(grid, x0, problems::uniform(random, -1e-3, 1e-3));
      EXPECT_NEAR(leastGap(grid, gap), lowest, 1e-12 + 1e-9 * lowest);
    }
  }
}

TEST(LeastGap, IsThatOfTheLowestCellNextToCellsWithoutABody)
{
  const Grid grid = problems::centredGrid(8, 9, 8e-3, 4e-3, false);
  Eigen::ArrayXXd gap = paraboloid(grid, 0.4e-3, 0.1e-3);
  gap.col(3).setConstant(no_body_gap);
  gap.col(5).setConstant(no_body_gap);
  gap.row(3).setConstant(no_body_gap);
  gap.row(5).setConstant(no_body_gap);
  EXPECT_EQ(leastGap(grid, gap), gap.minCoeff());
}

// Next to a kink, the parabola through the lowest cell may lead far below the gap. The bend on the other side of the
// kink limits its depth: the minimum of the gap is not lower than the cells by more than that.
TEST(LeastGap, NextToAKinkIsLimitedByTheBendOnTheOtherSide)
{
  const Grid grid = problems::centredGrid(8, 9, 8e-3, 4e-3, true);
  for (const double vertex : {-0.2e-3, -0.1e-3, 0.0, 0.1e-3})
  {
    Eigen::ArrayXXd gap = paraboloid(grid, 0, vertex);
    for (int j = 5; j < grid.ny; ++j)
    {
      gap.col(j) += 2 * grid.y(j);
    }
    EXPECT_LE(leastGap(grid, gap), gap.minCoeff());
    EXPECT_GE(leastGap(grid, gap), lowest - 2 * (2 * 40 * grid.dy * grid.dy) / 8 - 1e-12);
    EXPECT_LE(leastGap(grid, gap), lowest + 40 * grid.dy * grid.dy / 4 + 1e-12);
  }
}

// Crown and gauge corner: the approach of a patch must not depend on the position of the cells. With the lowest cell in
// place of the minimum it was wrong by 0.5 % at y = 4.9 mm on 16 × 32 cells. The remaining difference is the error of
// the penetration on the coarse grid, 0.07 % there.
TEST(LeastGap, MakesTheApproachIndependentOfTheCells)
{
  for (const double y : {0.0, 3e-3, 4.9e-3})
  {
    std::vector<double> approach[2];
    for (const int along : {24, 64})
    {
      ContactModelConfig config = manchesterScene();
      config.contact.method = NormalMethod::conjugate_gradient;
      config.contact.cells_along = along;
      config.contact.cells_across = 2 * along;
      config.contact.tolerance = 1e-3;
      WheelsetContact contact(config);
      WheelsetState state;
      state.y = y;
      state.force_z = -200e3;
      for (const PatchResult& patch : contact.evaluate(state).patches)
      {
        approach[along == 24 ? 0 : 1].push_back(patch.approach);
      }
    }
    ASSERT_EQ(approach[0].size(), approach[1].size());
    for (std::size_t k = 0; k < approach[0].size(); ++k)
    {
      std::cout << "y " << y << ": " << approach[0][k] << ", " << approach[1][k] << " m\n";
      EXPECT_NEAR(approach[0][k], approach[1][k], 1e-3 * approach[1][k]) << "y " << y;
    }
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
