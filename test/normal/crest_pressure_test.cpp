// SPDX-License-Identifier: BSD-3-Clause
#include "../../src/normal/crest_pressure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "gap_scenes.h"
#include "problems.h"
#include "wheel_rail_contact/normal/conjugate_gradients.h"

namespace wheel_rail_contact
{
namespace
{
const double pi = std::acos(-1.0);

/// What the infinite row of strips (cells of one, E* = 1) makes too much of the pressure in cell i, where the gap's
/// curvature jumps by one at s: by Fourier's transform over the waves phi + 2 pi m that look alike on the cells. Of a
/// wave k the strips' influence is 2 sinc(k / 2) / |k|, summed over those; the half-space's is 2 / |k|.
double errorOfStrips(double s, int i)
{
  constexpr int waves = 200, steps = 600;
  double sum = 0;
  for (int n = 0; n < steps; ++n)
  {
    const double phi = pi * (n + 0.5) / steps;
    double influence = 0;
    for (int m = -waves; m <= waves; ++m)
    {
      const double k = phi + 2 * pi * m;
      influence += (m % 2 == 0 ? 1 : -1) * 4 * std::sin(phi / 2) / (std::abs(k) * k);
    }
    std::complex<double> error = 0;
    for (int m = -waves; m <= waves; ++m)
    {
      const double k = phi + 2 * pi * m;
      const std::complex<double> jump = std::polar(1.0, -k * s) / std::complex<double>(0, k);
      error += jump * (1 / (k * k * influence) - 1 / (2 * std::abs(k)));
    }
    sum += std::real(error * std::polar(1.0, phi * i)) / steps;
  }
  return sum;
}

TEST(CrestPressure, cellErrorAtAJumpOfCurvatureIsThatOfAnInfiniteRowOfStrips)
{
  for (const double s : {0.05, 0.1, 0.3, 0.5, 0.8, 1.0})
  {
    for (int i = -4; i <= 4; ++i)
    {
      // Beyond three cells the first term of a series stands for all: 5 % off.
      EXPECT_NEAR(cellErrorAtJump(i - s), errorOfStrips(s, i), 1.5e-4) << "cell " << i << ", jump at " << s;
    }
  }
}

struct Pressures
{
  double raised = 0, highest_cell = 0;
};

/// Largest errors of the highest pressure over ten places of a gap among its cells, against cells eight times finer.
/// `gap(x, y)` is moved by parts of a cell.
template <typename Gap>
Pressures largestErrors(const Grid& grid, double load, const Gap& gap)
{
  ConjugateGradientsOptions options;
  options.residual = 1e-6;
  options.max_products = 1000;
  ConjugateGradients solver(options);
  Pressures worst;
  for (int place = 0; place < 10; ++place)
  {
    const double shift = 0.1 * place * grid.dy;
    const auto moved = [&](double x, double y) { return gap(x, y - shift); };
    NormalSolution found, fine;
    solver.solve(problems::underLoad(problems::sampled(grid, moved), load), false, found);
    solver.solve(problems::underLoad(problems::sampled(scenes::refined(grid, 8), moved), load), false, fine);
    EXPECT_TRUE(found.status == SolveStatus::converged && fine.status == SolveStatus::converged);
    EXPECT_FALSE(found.patches[0].touches_border);
    const double truth = fine.patches[0].max_pressure;
    worst.raised = std::max(worst.raised, std::abs(found.patches[0].max_pressure / truth - 1));
    worst.highest_cell = std::max(worst.highest_cell, std::abs(found.patches[0].pressure.maxCoeff() / truth - 1));
  }
  return worst;
}

/// A wheel of 0.46 m on a crown that a shoulder joins: the pressure is highest beside the joint.
double shoulder(double x, double y)
{
  return x * x / 0.92 + y * y / (y > 0 ? 0.1 : 0.8);
}

/// The same between two shoulders, on which two crests stand.
double lobes(double x, double y)
{
  constexpr double width = 7e-3;  // between the joints [m]
  const double beyond = std::max({y, -width - y, 0.0});
  return x * x / 0.92 + y * y / 3 + beyond * beyond / 0.15;
}

// Tolerances: the largest error found (0.67 and 0.87 %, 0.35 and 0.38 %; of the highest cell 4.0 and 4.7 %, 0.89 and
// 0.94 %), rounded up.
TEST(CrestPressure, besideAJointIsNearThatOfEightTimesFinerCells)
{
  struct Limit
  {
    int nx, ny;
    double error, over_cell;
  };
  for (const Limit& limit : {Limit{12, 32, 0.009, 0.2}, Limit{24, 64, 0.004, 0.45}})
  {
    const std::vector<Pressures> scenes{
        largestErrors(problems::centredGrid(limit.nx, limit.ny, 0.018, 0.026, true), 1e5, shoulder),
        largestErrors(problems::centredGrid(limit.nx, limit.ny, 0.019, 0.030, true), 1e5, lobes)};
    for (const Pressures& errors : scenes)
    {
      EXPECT_LT(errors.raised, limit.error) << limit.nx << " x " << limit.ny;
      EXPECT_LT(errors.raised, limit.over_cell * errors.highest_cell) << limit.nx << " x " << limit.ny;
    }
  }
}

// A crest may be no cell's: of two equal cells beside it each is lower.
TEST(CrestPressure, liesBetweenTwoEqualCells)
{
  const auto hertz = problems::hertzCase(2, 16, 32, true);
  ConjugateGradientsOptions options;
  options.residual = 1e-8;
  ConjugateGradients solver(options);
  NormalSolution solution;
  solver.solve(hertz.problem, false, solution);
  const Eigen::ArrayXXd& p = solution.patches[0].pressure;
  ASSERT_NEAR(p(0, 15) / p(0, 16), 1, 1e-9);
  const double raised = crestPressure(hertz.problem.patches[0], hertz.problem.modulus, p, 0, 15);
  EXPECT_NEAR(raised / hertz.exact.max_pressure, 1, 5e-4);
  EXPECT_GT(std::abs(p(0, 15) / hertz.exact.max_pressure - 1), 1e-3);
}

/// A row of cells (one row of a grid that is the same all along) over a gap of one column's height each.
struct Row
{
  PatchGap gap;
  Eigen::ArrayXXd pressure;

  Row(const std::vector<double>& heights, const std::vector<double>& pressures)
  {
    const auto columns = static_cast<int>(heights.size());
    gap.grid = {2, columns, 1e-3, 1e-3, 0, true};
    gap.gap = Eigen::Map<const Eigen::RowVectorXd>(heights.data(), columns).array();
    pressure = Eigen::Map<const Eigen::RowVectorXd>(pressures.data(), columns).array();
  }
  double at(int column) const { return crestPressure(gap, 1e11, pressure, 0, column); }
};

TEST(CrestPressure, besideAnUnloadedCellOrTheBorderIsTheCellsOwn)
{
  EXPECT_EQ(Row({0, 0, 0, 0}, {0, 1e9, 8e8, 0}).at(1), 1e9);
  EXPECT_EQ(Row({0, 0, 0, 0}, {1e9, 8e8, 0, 0}).at(0), 1e9);
  EXPECT_EQ(Row({0, 0, 0, 0}, {0, 0, 8e8, 1e9}).at(3), 1e9);
}

// A pressure that the box cuts has no edge at the border: what is taken off beside a true one is not.
TEST(CrestPressure, takesNoBorderOfTheGridForTheContactsEdge)
{
  const std::vector<double> flat(6, 0.0);
  const double cut = Row(flat, {3e8, 9e8, 1e9, 9e8, 7e8, 5e8}).at(2);
  const std::vector<double> wider(8, 0.0);
  const double edge = Row(wider, {0, 3e8, 9e8, 1e9, 9e8, 7e8, 5e8, 4e8}).at(3);
  EXPECT_NE(cut, edge);
  EXPECT_NEAR(cut / edge, 1, 0.02);
}

TEST(CrestPressure, ofWavesIsNotBelowTheirHighestCell)
{
  std::vector<double> waves, pressures;
  for (int j = 0; j < 24; ++j)
  {
    waves.push_back(1e-6 * std::cos(2 * pi * j / 5.0));
    pressures.push_back(1e9 * (1 - 0.3 * std::cos(2 * pi * j / 5.0)));
  }
  const Row row(waves, pressures);
  Eigen::Index crest = 0;
  row.pressure.row(0).segment(6, 12).maxCoeff(&crest);
  crest += 6;
  EXPECT_TRUE(showsWaves(row.gap, 1e11, row.pressure, 0, crest));
  EXPECT_GE(row.at(static_cast<int>(crest)), row.pressure(0, crest));
  EXPECT_FALSE(showsWaves(Row(std::vector<double>(24, 0.0), pressures).gap, 1e11, row.pressure, 0, crest));
}

TEST(CrestPressure, ofAHalfIsThatOfTheWhole)
{
  ConjugateGradientsOptions options;
  options.residual = 1e-9;
  ConjugateGradients solver(options);
  NormalSolution half, whole;
  solver.solve(problems::underLoad(problems::sampled(problems::centredGrid(16, 32, 0.018, 0.026, true), shoulder), 1e5),
               false, half);
  solver.solve(
      problems::underLoad(problems::sampled(problems::centredGrid(16, 32, 0.018, 0.026, false), shoulder), 1e5), false,
      whole);
  EXPECT_NEAR(half.patches[0].max_pressure / whole.patches[0].max_pressure, 1, 1e-6);
}
}  // namespace
}  // namespace wheel_rail_contact
