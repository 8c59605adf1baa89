// SPDX-License-Identifier: BSD-3-Clause
// Waves of a gap that are narrower than the cells: the cells do not show them, the gap's own slopes do.
#include <gtest/gtest.h>

#include <cmath>

#include "core/normal/estimate/unseen_slope.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "errors_of.h"
#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double width = 16e-3;  ///< of the grid [m]
constexpr int columns = 32;      ///< of the grid that does not see the wave
constexpr double wave = width / columns;

/// A bowl under load with a wave across that is as long as a cell of the coarse grid and zero in each one's centre.
NormalProblem wavyBowl(int nx, int ny, double amplitude)
{
  const double wavenumber = 2 * std::acos(-1.0) / wave;
  const auto gap = [=](double x, double y)
  { return 1.1 * x * x + 1.1 * y * y + amplitude * std::sin(wavenumber * (y + 0.5 * wave)); };
  return problems::underLoad(problems::sampled(problems::centredGrid(nx, ny, width, width, true), gap), 1e5);
}

PatchPressure solved(const NormalProblem& problem, double& estimate)
{
  ConjugateGradients solver;
  NormalSolution solution;
  solver.solve(problem, false, solution);
  EXPECT_EQ(solution.status, SolveStatus::converged);
  estimate = errorsOf(solver, problem, solution)[0].max_pressure;
  return solution.patches[0];
}

/// What the cells do not show of a gap, across at x = 0 by its own differences.
template <typename Gap>
Eigen::ArrayXd unseenSlope(const Grid& grid, Gap gap)
{
  PatchGap patch = problems::sampled(grid, gap);
  constexpr double near = 1e-8;  // [m]
  fillUnseenSlope(patch,
                  [&](Eigen::Index j)
                  {
                    const double y = grid.y(static_cast<int>(j));
                    return (gap(0, y + near) - gap(0, y - near)) / (2 * near);
                  });
  return patch.unseen_slope;
}
}  // namespace

// A yawed wheel's crest runs askew over the grid: beside x = 0 the gap's slope across is another one. Counted as
// unseen, it made errors of the pressure of up to 4 % of it out of 0.1 %. What central differences of the slopes have
// of rounding is 1e-10.
TEST(UnseenSlope, CellsShowAllOfASmoothGapAskew)
{
  const auto askew = [](double x, double y)
  { return 1.1 * (x + 0.05 * y) * (x + 0.05 * y) + (y > 1e-3 ? 2.3 : 1.1) * (y - 1e-3) * (y - 1e-3); };
  for (const int nx : {8, 9, 16})
  {
    const Grid grid = problems::centredGrid(nx, columns, width, width, false);
    EXPECT_LT(unseenSlope(grid, askew).maxCoeff(), 1e-9) << nx;
  }
}

TEST(UnseenSlope, SlopesOfNarrowWavesAreUnseen)
{
  const double steepest = 1e-3, wavenumber = 2 * std::acos(-1.0) / wave;
  const auto wavy = [=](double x, double y)
  { return 1.1 * x * x + 1.1 * y * y + steepest / wavenumber * std::sin(wavenumber * (y + 0.5 * wave)); };
  for (const bool even : {true, false})
  {
    const Grid grid = problems::centredGrid(8, columns, width, width, even);
    EXPECT_NEAR(unseenSlope(grid, wavy).maxCoeff(), steepest, 1e-3 * steepest) << even;
  }
}

// Johnson (1985), eq. 13.2: pressed flat, a wave of slopes up to s adds E* s / 2 to the pressure. That is on a plane:
// on the bowl it comes to within one per cent of it. Without slopes the estimate misses the wave.
TEST(UnseenSlope, EstimateCountsWavesNarrowerThanTheCells)
{
  for (const double amplitude : {1e-7, 2e-7, 3e-7})
  {
    double seen = 0, blind = 0, fine = 0;
    NormalProblem problem = wavyBowl(columns, columns, amplitude);
    const double max_pressure = solved(problem, blind).max_pressure;
    problem.patches[0].unseen_slope.setConstant(columns, 2 * std::acos(-1.0) / wave * amplitude);
    EXPECT_EQ(solved(problem, seen).max_pressure, max_pressure);
    const double error = solved(wavyBowl(2 * columns, 16 * columns, amplitude), fine).max_pressure / max_pressure - 1;
    EXPECT_GT(error, 0.05) << amplitude;
    EXPECT_GT(seen, 0.99 * error) << amplitude;
    EXPECT_LT(seen, 2 * error) << amplitude;
    EXPECT_LT(blind, error) << amplitude;
  }
}
}  // namespace wheel_rail_contact::core
