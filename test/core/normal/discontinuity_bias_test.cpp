// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/discontinuity_bias.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "error_samples.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double modulus = 1.14e11;  // steel on steel [Pa]

/// Bowl whose curvature across jumps by `jump` times its value at y = `discontinuity`.
scenes::Gap discontinuous(double discontinuity, double jump)
{
  return [=](double x, double y)
  {
    const double beyond = std::max(y - discontinuity, 0.0);
    return x * x + 4 * (y * y + jump * beyond * beyond);
  };
}

/// Patch on a grid that covers the pressure of 20 kN on every gap of these tests.
NormalProblem problemOf(const scenes::Gap& gap, const GridSize& size, bool symmetric = false)
{
  NormalProblem problem;
  problem.modulus = modulus;
  problem.value = 2e4;
  problem.patches.resize(1);
  const double length = 13e-3, width = 7e-3, dx = length / size.along, dy = width / size.across;
  problem.patches[0].grid = {size.along, size.across, dx, dy, -0.5 * (size.across - 1) * dy, symmetric};
  scenes::sample(gap, problem.patches[0]);
  return problem;
}

PatchPressure solve(const NormalProblem& problem)
{
  ConjugateGradients solver(scenes::strictOptions());
  NormalSolution solution;
  solver.solve(problem, false, solution);
  EXPECT_EQ(solution.status, SolveStatus::converged);
  EXPECT_FALSE(solution.patches[0].touches_border);
  return solution.patches[0];
}

DiscontinuitySums sumsOf(const NormalProblem& problem, const PatchPressure& patch)
{
  EdgePolygon polygon;
  polygon.frame(patch.pressure, patch.grid.symmetric);
  EXPECT_GT(polygon.cells(patch.grid.dx / patch.grid.dy), 0);
  return sumAtDiscontinuities({polygon, problem.patches[0], problem.modulus, patch.max_pressure});
}

TEST(DiscontinuityBias, SmoothGapsHaveNone)
{
  const NormalProblem problem = problemOf(discontinuous(0, 0), {16, 32});
  const PatchPressure patch = solve(problem);
  EXPECT_EQ(sumsOf(problem, patch).sizes, 0);
  EXPECT_EQ(patch.moved_at_discontinuities, 0);
}

// The ends of the column along the track have no outward side: the lines on both sides are unloaded.
TEST(DiscontinuityBias, BiasOfASingleColumnIsMirrorSymmetric)
{
  NormalProblem problem = problemOf(discontinuous(0.05e-3, 3), {16, 32});
  PatchGap& gap = problem.patches[0];
  PatchPressure patch;
  patch.grid = gap.grid;
  patch.pressure.setZero(gap.gap.rows(), gap.gap.cols());
  patch.pressure.block(4, 15, 8, 1) = 1e9;
  patch.max_pressure = 1e9;
  const DiscontinuitySums sums = sumsOf(problem, patch);
  EXPECT_GT(sums.sizes, 0.01);
  gap.gap = gap.gap.rowwise().reverse().eval();
  patch.pressure = patch.pressure.rowwise().reverse().eval();
  EXPECT_NEAR(sumsOf(problem, patch).bias, sums.bias, 1e-5);
}

TEST(DiscontinuityBias, IsIndependentOfOrientation)
{
  const NormalProblem problem = problemOf(discontinuous(1.6e-3, -1.1), {16, 32});
  const PatchPressure patch = solve(problem);
  const DiscontinuitySums sums = sumsOf(problem, patch);
  EXPECT_GT(sums.sizes, 0.1);
  constexpr double tolerance = 1e-4;  // sums in single precision [cells]
  const auto look = [&](auto turn)
  {
    NormalProblem turned = problem;
    PatchPressure seen = patch;
    turned.patches[0].gap = turn(problem.patches[0].gap);
    seen.pressure = turn(patch.pressure);
    const DiscontinuitySums there = sumsOf(turned, seen);
    EXPECT_NEAR(there.bias, sums.bias, tolerance);
    EXPECT_NEAR(there.sizes, sums.sizes, tolerance);
  };
  look([](const Eigen::ArrayXXd& a) -> Eigen::ArrayXXd { return a.colwise().reverse(); });
  look([](const Eigen::ArrayXXd& a) -> Eigen::ArrayXXd { return a.rowwise().reverse(); });

  const NormalProblem half = problemOf(discontinuous(1.6e-3, -1.1), {16, 32}, true);
  const PatchPressure stored = solve(half);
  EXPECT_NEAR(2 * sumsOf(half, stored).bias, sums.bias, 1e-3);
  EXPECT_NEAR(stored.moved_at_discontinuities / patch.moved_at_discontinuities, 1, 1e-3);
}

/// Mean absolute errors of areas with and without the correction for curvature discontinuities [cells].
class AreaErrors
{
 public:
  void add(const scenes::Gap& gap, const GridSize& size)
  {
    const NormalProblem problem = problemOf(gap, size);
    const PatchPressure coarse = solve(problem), fine = solve(problemOf(gap, {96, 192}));
    const double error = (coarse.area - fine.area) / coarse.grid.cellArea();
    with_ += std::abs(error);
    without_ += std::abs(error + sumsOf(problem, coarse).bias);
    ++count_;
  }
  double with() const { return with_ / count_; }
  double without() const { return without_ / count_; }
  void print(const char* gaps) const
  {
    std::cout << count_ << ' ' << gaps << ": mean area error " << with() << " cells, " << without()
              << " cells without the correction\n";
  }

 private:
  double with_ = 0, without_ = 0;
  int count_ = 0;
};

// Discontinuities from well inside the edge to beyond it, with jumps to higher and lower curvature.
TEST(DiscontinuityBias, CorrectedAreaIsCloserToThatOfFineCells)
{
  AreaErrors errors;
  for (const double jump : {-0.9, -0.5, 1.0, 3.0})
  {
    for (double discontinuity = 0.8e-3; discontinuity < 2.5e-3; discontinuity += 0.15e-3)
    {
      errors.add(discontinuous(discontinuity, jump), {12, 24});
    }
  }
  errors.print("curvature discontinuities");
  EXPECT_LT(errors.with(), 0.6 * errors.without());
}

// A curvature that increases smoothly has steps as well.
TEST(DiscontinuityBias, CorrectedAreaIsCloserAlsoForSmoothlyIncreasingCurvature)
{
  AreaErrors errors;
  for (const GridSize& size : {GridSize{8, 16}, GridSize{12, 24}})
  {
    for (double fourth = 1e5; fourth < 1.5e6; fourth *= 1.3)
    {
      errors.add([=](double x, double y) { return x * x + (1 + fourth * y * y) * y * y; }, size);
    }
  }
  errors.print("smooth gaps");
  EXPECT_LT(errors.with(), 0.6 * errors.without());
}
}  // namespace
}  // namespace wheel_rail_contact::core
