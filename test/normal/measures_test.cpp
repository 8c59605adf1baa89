// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems.h"
#include "wheel_rail_contact/normal/conjugate_gradients.h"

namespace wheel_rail_contact
{
namespace
{
using problems::hertzCase;

struct Errors
{
  double max_pressure = 0, highest_cell = 0, area = 0, counted_area = 0, approach = 0;
};

/// Largest relative errors on Hertz contacts of five shapes, boxes of different margin and place.
Errors worstErrors(int nx, int ny)
{
  ConjugateGradientsOptions options;
  options.residual = 1e-6;  // so that what is left is the cells' error
  ConjugateGradients solver(options);
  Errors worst;
  for (const double ratio : {0.3, 1.0, 2.0, 5.0, 10.0})
  {
    for (const double margin : {1.1, 1.15, 1.2})
    {
      for (const double shift : {0.0, 0.2, 0.5})
      {
        const auto hertz = hertzCase(ratio, nx, ny, true, margin, shift);
        NormalSolution solution;
        solver.solve(hertz.problem, false, solution);
        const PatchPressure& patch = solution.patches[0];
        const double counted = static_cast<double>((patch.pressure > 0).count()) * patch.grid.cellArea();
        const auto raise = [](double& largest, double found, double exact)
        { largest = std::max(largest, std::abs(found / exact - 1)); };
        raise(worst.max_pressure, patch.max_pressure, hertz.exact.max_pressure);
        raise(worst.highest_cell, patch.pressure.maxCoeff(), hertz.exact.max_pressure);
        raise(worst.area, patch.area, hertz.exact.area);
        raise(worst.counted_area, counted, hertz.exact.area);
        raise(worst.approach, solution.approach, hertz.exact.approach);
      }
    }
  }
  return worst;
}

// Tolerances: the worst case found, rounded up.
TEST(Measures, areaIsATenthAsWrongAsCountedCells)
{
  const Errors coarse = worstErrors(8, 16), medium = worstErrors(16, 32), fine = worstErrors(32, 64);
  EXPECT_LT(coarse.area, 0.016);
  EXPECT_LT(medium.area, 0.006);
  EXPECT_LT(fine.area, 0.004);
  EXPECT_LT(medium.area, 0.2 * medium.counted_area);
  EXPECT_LT(fine.area, 0.3 * fine.counted_area);
}

TEST(Measures, maxPressureBetweenTheCellsBeatsTheHighestCell)
{
  const Errors coarse = worstErrors(8, 16), medium = worstErrors(16, 32), fine = worstErrors(32, 64);
  EXPECT_LT(coarse.max_pressure, 0.008);
  EXPECT_LT(medium.max_pressure, 0.0015);
  EXPECT_LT(fine.max_pressure, 0.0004);
  EXPECT_LT(medium.max_pressure, 0.6 * medium.highest_cell);
  EXPECT_LT(fine.max_pressure, 0.6 * fine.highest_cell);
}

TEST(Measures, approachConvergesFasterThanTheCells)
{
  EXPECT_LT(worstErrors(8, 16).approach, 0.005);
  EXPECT_LT(worstErrors(16, 32).approach, 0.0015);
  EXPECT_LT(worstErrors(32, 64).approach, 0.0004);
}

TEST(Measures, areaOfTwoLobesIsThatOfFourTimesFinerCells)
{
  const auto lobes = [](double x, double y)
  { return x * x / 0.92 + std::min((y + 5e-3) * (y + 5e-3) / 0.2, (y - 5e-3) * (y - 5e-3) / 0.12 + 2e-6); };
  ConjugateGradients solver;
  const auto area = [&](int factor)
  {
    const Grid grid = problems::centredGrid(16 * factor, 48 * factor, 0.017, 0.020, true);
    NormalSolution solution;
    solver.solve(problems::underLoad(problems::sampled(grid, lobes), 1e5), false, solution);
    EXPECT_FALSE(solution.patches[0].touches_border);
    return solution.patches[0].area;
  };
  EXPECT_NEAR(area(1) / area(4), 1, 0.01);
}

TEST(Measures, forceIsThePressureTimesTheArea)
{
  const auto hertz = hertzCase(2, 16, 32, true);
  NormalSolution solution;
  ConjugateGradients().solve(hertz.problem, false, solution);
  const PatchPressure& patch = solution.patches[0];
  EXPECT_NEAR(patch.force / 1e5, 1, 1e-12);
  EXPECT_NEAR(patch.force / (patch.pressure.sum() * 2 * patch.grid.dx * patch.grid.dy), 1, 1e-12);
}
}  // namespace
}  // namespace wheel_rail_contact
