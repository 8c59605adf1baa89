// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/hertz_solver.h"

#include "core/normal/solvers/kik_piotrowski.h"
#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
using namespace problems;

/// Bowl rotated by `angle` about z, with its lowest point at (x0, y0).
auto turnedBowl(const GapCurvature& curvature, double angle, double x0, double y0)
{
  return [=](double x, double y)
  {
    const double first = std::cos(angle) * (x - x0) + std::sin(angle) * (y - y0);
    const double second = std::cos(angle) * (y - y0) - std::sin(angle) * (x - x0);
    return curvature.a * first * first + curvature.b * second * second;
  };
}

TEST(HertzSolver, IsExactOnBowls)
{
  for (const double ratio : {0.05, 1.0, 3.0, 40.0})
  {
    for (const bool symmetric : {true, false})
    {
      const auto hertz = hertzCase(ratio, 8, 24, symmetric, 1.2, 0.37);
      HertzSolver solver;
      const NormalSolution solution = problems::converged(solver, hertz.problem);
      const PatchPressure& patch = solution.patches[0];
      EXPECT_NEAR(patch.max_pressure / hertz.exact.max_pressure, 1, 1e-9) << ratio;
      EXPECT_NEAR(patch.area / hertz.exact.area, 1, 1e-9) << ratio;
      EXPECT_NEAR(solution.approach / hertz.exact.approach, 1, 1e-9) << ratio;
      EXPECT_NEAR(patch.force / hertz.exact.force, 1, 1e-9) << ratio;
      EXPECT_FALSE(patch.touches_border);
      // The gap is a paraboloid. The rest of the estimate is the error of the references used in the calibration.
      EXPECT_LT(errorsOf(solver, hertz.problem, solution)[0].largest(), 0.01);
    }
  }
}

TEST(HertzSolver, CellPressuresAreMeansOfTheEllipsoid)
{
  const auto hertz = hertzCase(3, 16, 32, true, 1.1, 0.5);
  HertzSolver solver;
  const NormalSolution solution = problems::solved(solver, hertz.problem);
  const PatchPressure& patch = solution.patches[0];
  const Grid& grid = patch.grid;
  constexpr int parts = 50;
  Eigen::ArrayXXd means = Eigen::ArrayXXd::Zero(grid.rows(), grid.ny);
  for (int j = 0; j < grid.ny * parts; ++j)
  {
    const double y = (grid.y(0) + ((j + 0.5) / parts - 0.5) * grid.dy) / hertz.exact.semi_axis_y;
    for (int i = 0; i < grid.rows() * parts; ++i)
    {
      const double x = (i + 0.5) / parts * grid.dx / hertz.exact.semi_axis_x;
      means(i / parts, j / parts) += std::sqrt(std::max(1 - x * x - y * y, 0.0)) / (parts * parts);
    }
  }
  // Two Gauss points across a column miss the root at the edge by 0.6 % of the highest pressure.
  EXPECT_LT((patch.pressure / hertz.exact.max_pressure - means).abs().maxCoeff(), 8e-3);
  EXPECT_LE(patch.pressure.maxCoeff(), patch.max_pressure);
}

TEST(HertzSolver, PressuresOnAnyGridCarryTheForce)
{
  // Ellipses of 11 mm by 1.7 mm: on some thousand cells, cut by the border, and between the centres of four cells.
  struct Cells
  {
    double size;  // [mm]
    int along, across;
    bool cut;
  };
  HertzSolver solver;
  for (const Cells& cells : {Cells{0.15, 100, 90, false}, {1, 12, 12, false}, {1, 9, 6, true}, {20, 4, 4, false}})
  {
    for (const double angle : {0.0, 0.7})
    {
      for (const double shift : {-0.4, 0.1, 0.5})
      {
        const double size = 1e-3 * cells.size;
        const Grid grid{cells.along, cells.across, size, size, (shift - 0.5 * cells.across) * size, false};
        const GapCurvature curvature{2, 90};
        const NormalProblem problem = underLoad(sampled(grid, turnedBowl(curvature, angle, 0, 0)), 2e4);
        const NormalSolution solution = problems::solved(solver, problem);
        const PatchPressure& patch = solution.patches[0];
        const std::string label = std::to_string(cells.size) + " mm, rotated by " + std::to_string(angle);
        ASSERT_EQ(solution.status, SolveStatus::converged) << label;
        EXPECT_EQ(patch.touches_border, cells.cut) << label;
        EXPECT_NEAR(patch.pressure.sum() * grid.cellArea() / problem.value, 1, 1e-9) << label;
        EXPECT_LE(patch.pressure.maxCoeff(), patch.max_pressure) << label;
        EXPECT_GE(patch.pressure.minCoeff(), 0) << label;
      }
    }
  }
}

TEST(HertzSolver, FindsPrincipalDirectionsAndPositionBetweenCells)
{
  for (const double angle : {-1.2, -0.4, 0.0, 0.3, 0.7, 1.5})
  {
    const GapCurvature curvature = {0.8, 5.0};
    const Grid grid = centredGrid(24, 40, 0.024, 0.016, false);
    const double x0 = 0.37e-3, y0 = -0.83e-3;
    const PatchGap patch = sampled(grid, turnedBowl(curvature, angle, x0, y0));
    const GapMinimum minimum = fitMinimum(patch);
    EXPECT_NEAR(minimum.x, x0, 1e-9) << angle;
    EXPECT_NEAR(minimum.y, y0, 1e-9) << angle;
    EXPECT_NEAR(minimum.gap, 0, 1e-12) << angle;
    // The first direction is the one nearer to x.
    const bool swapped = std::abs(angle) > std::acos(-1.0) / 4;
    EXPECT_NEAR(minimum.curvature.a, swapped ? curvature.b : curvature.a, 1e-6) << angle;
    EXPECT_NEAR(minimum.curvature.b, swapped ? curvature.a : curvature.b, 1e-6) << angle;
    const double turn = swapped ? angle - std::copysign(std::acos(0.0), angle) : angle;
    EXPECT_NEAR(minimum.angle, turn, 1e-6) << angle;
    // Rotating the bowl changes only the orientation of the ellipse.
    HertzSolver solver;
    const NormalSolution solution = problems::solved(solver, underLoad(patch, 2e4));
    const HertzContact exact = hertzForForce(curvature, steel(), 2e4);
    EXPECT_NEAR(solution.patches[0].max_pressure / exact.max_pressure, 1, 1e-6) << angle;
    Eigen::Index row = 0, column = 0;
    solution.patches[0].pressure.maxCoeff(&row, &column);
    EXPECT_LT(std::abs(grid.x(static_cast<int>(row)) - x0), grid.dx);
    EXPECT_LT(std::abs(grid.y(static_cast<int>(column)) - y0), grid.dy);
  }
}

template <typename Solver>
class ClosedForm : public testing::Test
{
};
using ClosedForms = testing::Types<HertzSolver, KikPiotrowski>;
TYPED_TEST_SUITE(ClosedForm, ClosedForms, );

template <typename Solver>
class EachSolver : public testing::Test
{
};
using Solvers = testing::Types<HertzSolver, KikPiotrowski, ConjugateGradients>;
TYPED_TEST_SUITE(EachSolver, Solvers, );

TYPED_TEST(ClosedForm, PatchesShareTheLoadAtOneApproach)
{
  NormalProblem problem = hertzCase(1, 16, 16, true, 1.3).problem;
  problem.patches.push_back(hertzCase(6, 16, 32, true, 1.3).problem.patches[0]);
  problem.patches.push_back(problem.patches[0]);
  problem.patches[1].gap += 2e-5;
  problem.patches[1].weight = 0.7;
  problem.patches[2].gap += 1;  // does not touch
  TypeParam solver;
  const NormalSolution both = problems::converged(solver, problem);
  EXPECT_NEAR((both.patches[0].force + 0.7 * both.patches[1].force) / problem.value, 1, 1e-9);
  EXPECT_EQ(both.patches[2].force, 0);
  EXPECT_EQ(both.patches[2].pressure.maxCoeff(), 0);
  const NormalSolution same = problems::solved(solver, problems::atApproach(problem, both.approach));
  EXPECT_NEAR(same.patches[1].force / both.patches[1].force, 1, 1e-9);
  NormalProblem second = problems::atApproach(problem, 0.7 * both.approach);
  second.patches = {problem.patches[1]};
  second.patches[0].weight = 1;
  EXPECT_NEAR(problems::solved(solver, second).patches[0].force / both.patches[1].force, 1, 1e-9);
}

TYPED_TEST(ClosedForm, RejectsAGapWithoutPositiveCurvature)
{
  const Grid grid = centredGrid(16, 32, 0.02, 0.02, true);
  TypeParam solver;
  for (const double saddle : {0.0, 0.1})  // a valley and a saddle
  {
    const auto gap = [saddle](double x, double y) { return y * y - saddle * x * x; };
    const SolveStatus status = problems::solved(solver, underLoad(sampled(grid, gap), 1e4)).status;
    EXPECT_EQ(status, SolveStatus::no_positive_curvature);
    EXPECT_FALSE(isUsable(status));
  }
}

TEST(HertzSolver, PredictsItsErrorFromASolutionOnAGrid)
{
  // Arcs that meet under the peak, 10 % apart in curvature. The estimate depends only on the approach of a solution,
  // and the two approaches differ by less than a tenth.
  const Grid grid = centredGrid(16, 32, 0.014, 0.014, true);
  const auto discontinuity = [](double x, double y) { return x * x + (y < 0 ? 1 : 1.1) * y * y; };
  const NormalProblem problem = underLoad(sampled(grid, discontinuity), 5e4);
  HertzSolver hertz;
  ConjugateGradients conjugate_gradients;
  const NormalSolution own = problems::solved(hertz, problem), on_grid = problems::solved(conjugate_gradients, problem);
  ASSERT_TRUE(isUsable(own.status) && isUsable(on_grid.status));
  const ErrorEstimate from_own = errorsOf(hertz, problem, own)[0];
  const ErrorEstimate from_grid = errorsOf(hertz, problem, on_grid)[0];
  EXPECT_GT(from_own.largest(), 0.01);
  EXPECT_NEAR(from_grid.max_pressure, from_own.max_pressure, 0.1 * from_own.max_pressure);
  EXPECT_NEAR(from_grid.area, from_own.area, 0.1 * from_own.area);
  EXPECT_NEAR(from_grid.approach, from_own.approach, 0.1 * from_own.approach);

  NormalProblem saddle = problem;
  saddle.patches[0] = sampled(grid, [](double x, double y) { return y * y - 1e-3 * x * x; });
  EXPECT_TRUE(std::isinf(errorsOf(hertz, saddle, on_grid)[0].largest()));
}

TEST(HertzSolver, RejectsAPatchThatCarriesNoLoadWithoutPositiveCurvature)
{
  const Grid grid = centredGrid(16, 32, 0.014, 0.014, true);
  const PatchGap bowl = sampled(grid, [](double x, double y) { return x * x + y * y; });
  const PatchGap apart = sampled(grid, [](double x, double y) { return 1e-3 + y * y - 1e-3 * x * x; });
  NormalProblem problem = underLoad(bowl, 1e4);
  problem.patches.push_back(apart);  // too far away to carry any load
  HertzSolver solver;
  const NormalSolution solution = problems::solved(solver, problem);
  EXPECT_EQ(solution.status, SolveStatus::no_positive_curvature);
}

TYPED_TEST(EachSolver, FlagsAGridThatCutsTheContact)
{
  TypeParam solver;
  const auto flagged = [&](const NormalProblem& problem)
  { return problems::solved(solver, problem).patches[0].touches_border; };
  // The region of interpenetration of KikPiotrowski is wider than the ellipse.
  const double enough = std::is_same_v<TypeParam, KikPiotrowski> ? 1.2 : 1.1;
  for (const bool symmetric : {true, false})
  {
    EXPECT_TRUE(flagged(hertzCase(2, 16, 32, symmetric, 0.9).problem));
    EXPECT_FALSE(flagged(hertzCase(2, 16, 32, symmetric, enough).problem));
    EXPECT_TRUE(flagged(hertzCase(2, 16, 32, symmetric, 1.2, 5).problem)) << "cut on one side only";
  }
}

TYPED_TEST(EachSolver, ReportsNoContactBeforeFirstTouch)
{
  const NormalProblem problem = hertzCase(2, 16, 32, true).problem;
  // The closed forms find the lowest point between the cells, at a gap of 0.
  const double touch = std::is_same_v<TypeParam, ConjugateGradients> ? problem.patches[0].gap.minCoeff() : 0;
  TypeParam solver;
  const NormalSolution solution = problems::solved(solver, problems::atApproach(problem, touch - 1e-9));
  EXPECT_EQ(solution.status, SolveStatus::no_contact);
  EXPECT_TRUE(isUsable(solution.status));
  EXPECT_EQ(solution.patches[0].force, 0);
  EXPECT_EQ(solution.patches[0].pressure.maxCoeff(), 0);
  EXPECT_FALSE(solution.patches[0].touches_border);
}

TEST(HertzSolver, RejectsInvalidProblems)
{
  HertzSolver solver;
  NormalProblem problem = hertzCase(2, 16, 32, true).problem;
  problem.patches[0].gap(3, 4) = std::nan("");
  EXPECT_EQ(problems::solved(solver, problem).status, SolveStatus::invalid_problem);
  EXPECT_EQ(problems::solved(solver, hertzCase(2, 16, 2, true).problem).status, SolveStatus::invalid_problem);
}
}  // namespace
}  // namespace wheel_rail_contact::core
