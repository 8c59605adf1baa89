// SPDX-License-Identifier: BSD-3-Clause
// Waves of a gap that are narrower than the cells: the cells do not show them, but the slopes of the gap do.
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
constexpr int columns = 32;      ///< of the grid that does not resolve the wave
constexpr double wave = width / columns;

/// Bowl under load with a wave across whose length is a cell of the coarse grid. It is zero at each cell centre.
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

/// Part of the slope of a gap across, at x = 0, that its cells do not show; the slope is from finite differences.
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

// The peak under a yawed wheel is oblique to the grid: next to x = 0 the slope of the gap across is different. If this
// counted as unseen, estimates of 0.1 % would become up to 4 %. The central differences of the slopes have rounding
// errors of 1e-10.
TEST(UnseenSlope, IsZeroForASmoothObliqueGap)
{
  const auto askew = [](double x, double y)
  { return 1.1 * (x + 0.05 * y) * (x + 0.05 * y) + (y > 1e-3 ? 2.3 : 1.1) * (y - 1e-3) * (y - 1e-3); };
  for (const int nx : {8, 9, 16})
  {
    const Grid grid = problems::centredGrid(nx, columns, width, width, false);
    EXPECT_LT(unseenSlope(grid, askew).maxCoeff(), 1e-9) << nx;
  }
}

TEST(UnseenSlope, IsTheSlopeOfWavesNarrowerThanTheCells)
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

// Johnson (1985), eq. 13.2: flattening a wave of slopes up to s adds E* s / 2 to the pressure. This holds on a plane,
// and on the bowl within one per cent. Without the slopes the estimate misses the wave.
TEST(UnseenSlope, EstimateIncludesWavesNarrowerThanTheCells)
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
