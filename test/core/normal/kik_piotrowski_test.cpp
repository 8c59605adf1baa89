// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/kik_piotrowski.h"

#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
using namespace problems;

constexpr double wheel = 0.5 / 0.46;  ///< coefficient A for a wheel of 460 mm radius [1/m]

NormalSolution stripSolution(const NormalProblem& problem)
{
  KikPiotrowski solver;
  return problems::converged(solver, problem);
}

/// Deviations from a reference [-].
struct Deviation
{
  double max_pressure, approach, rms;
};

Deviation deviation(const NormalProblem& problem, const NormalSolution& reference)
{
  const NormalSolution solution = stripSolution(problem);
  const Eigen::ArrayXXd &p = solution.patches[0].pressure, &q = reference.patches[0].pressure;
  return {solution.patches[0].max_pressure / reference.patches[0].max_pressure - 1,
          solution.approach / reference.approach - 1, std::sqrt((p - q).square().sum() / q.square().sum())};
}

Deviation fromConjugateGradients(const NormalProblem& problem)
{
  ConjugateGradients solver;
  const NormalSolution reference = problems::solved(solver, problem);
  EXPECT_EQ(reference.status, SolveStatus::converged);
  EXPECT_FALSE(reference.patches[0].touches_border);
  return deviation(problem, reference);
}

/// Deviations from Hertz on ellipses a/b = 1, 5 and 1/5 are inherent in the method. A prototype had -6, -3 and 9 %
/// (rms) on the circle. On 5:1 it had -14, -1 and 31 %; this corresponds to the method without its shape correction.
TEST(KikPiotrowski, HasItsKnownBiasOnEllipses)
{
  struct Case
  {
    double a_over_b, max_pressure, approach, rms;
  };
  for (const Case& known :
       {Case{1, -0.061, -0.031, 0.09}, Case{5, -0.103, -0.053, 0.14}, Case{0.2, -0.103, -0.053, 0.14}})
  {
    double low = 1e-3, high = 1e3;  // ratio of the curvatures that gives these semi-axes
    while (high / low > 1 + 1e-9)
    {
      const double ratio = std::sqrt(low * high);
      const HertzContact contact = hertzForForce({wheel, wheel * ratio}, problems::steel(), 1e5);
      (contact.semi_axis_x / contact.semi_axis_y < known.a_over_b ? low : high) = ratio;
    }
    const auto hertz = hertzCase(low, 64, 64, true, 1.2);
    const NormalSolution exact = problems::solved(hertz.problem);
    const Deviation found = deviation(hertz.problem, exact);
    EXPECT_NEAR(found.max_pressure, known.max_pressure, 0.005) << known.a_over_b;
    EXPECT_NEAR(found.approach, known.approach, 0.003) << known.a_over_b;
    EXPECT_NEAR(found.rms, known.rms, 0.005) << known.a_over_b;
  }
}

TEST(KikPiotrowski, EllipsesHaveTheHertzAxisRatio)
{
  for (const double ratio : {0.1, 0.5, 1.0, 4.0, 30.0})
  {
    const auto hertz = hertzCase(ratio, 128, 128, true, 1.3);
    const NormalSolution solution = stripSolution(hertz.problem);
    const PatchPressure& patch = solution.patches[0];
    const auto count = [](const Eigen::Array<bool, Eigen::Dynamic, 1>& loaded)
    { return static_cast<double>(loaded.count()); };
    const double length = 2 * count(patch.pressure.rowwise().maxCoeff() > 0) * patch.grid.dx;
    const double width = count(patch.pressure.colwise().maxCoeff().transpose() > 0) * patch.grid.dy;
    // Tolerance: about two cells in a hundred.
    EXPECT_NEAR(length / width * hertz.exact.semi_axis_y / hertz.exact.semi_axis_x, 1, 0.03) << ratio;
    EXPECT_NEAR(patch.area / (0.25 * std::acos(-1.0) * length * width), 1, 0.03) << ratio;
  }
}

TEST(KikPiotrowski, PressureCarriesTheLoad)
{
  for (const bool symmetric : {true, false})
  {
    const auto hertz = hertzCase(2.5, 96, 96, symmetric, 1.3, 0.3);
    const NormalSolution solution = stripSolution(hertz.problem);
    const PatchPressure& patch = solution.patches[0];
    EXPECT_NEAR(patch.force / hertz.problem.value, 1, 1e-9);
    // The midpoint rule on 75 cells, against the closed form along and a second-order rule across.
    EXPECT_NEAR(patch.pressure.sum() * patch.grid.cellArea() / patch.force, 1, 2e-3);
    EXPECT_FALSE(patch.touches_border);
  }
}

TEST(KikPiotrowski, MirroredGapsNextToAStepGiveMirroredPressures)
{
  // A ridge with a slope on one side and, on the other, a step up to a plane that does not open along x.
  const double width = std::ldexp(1.0, -11);  // the deepest column then lies exactly in its strip
  const Grid grid{8, 5, 1e-3, width, -2 * width, false};
  NormalProblem problem;
  problem.modulus = problems::steel();
  problem.control = NormalProblem::Control::approach;
  problem.value = 1e-4;
  problem.patches = {sampled(grid, [](double x, double y) { return 0.2 * std::abs(y) + (y <= 0 ? 2 * x * x : 0); })};
  const NormalSolution solution = stripSolution(problem);
  problem.patches[0].gap = problem.patches[0].gap.rowwise().reverse().eval();
  const NormalSolution mirrored = stripSolution(problem);
  ASSERT_GT(solution.patches[0].force, 0);
  ASSERT_TRUE(solution.patches[0].pressure.allFinite());
  // Sums in another order differ by rounding. Near the edge the difference is under a root.
  EXPECT_NEAR(mirrored.patches[0].force / solution.patches[0].force, 1, 1e-12);
  EXPECT_NEAR(mirrored.patches[0].max_pressure / solution.patches[0].max_pressure, 1, 1e-12);
  const Eigen::ArrayXXd reversed = mirrored.patches[0].pressure.rowwise().reverse();
  EXPECT_LT((reversed - solution.patches[0].pressure).abs().maxCoeff(), 1e-9 * solution.patches[0].max_pressure);
}

TEST(KikPiotrowski, LoadFollowsTheHertzPowerLawOnEllipses)
{
  NormalProblem problem = hertzCase(3, 32, 64, true, 1.3).problem;
  const double one = stripSolution(problem).approach;
  problem.value *= 0.5;
  // Exact in the limit of narrow strips; here 64 columns.
  EXPECT_NEAR(stripSolution(problem).approach / one, std::pow(0.5, 2.0 / 3.0), 2e-4);
}

TEST(KikPiotrowski, AlongAndAcrossAreEquivalentOnEllipses)
{
  const NormalSolution flat = stripSolution(hertzCase(6, 64, 256, true, 1.4).problem);
  NormalProblem turned = hertzCase(6, 64, 256, true, 1.4).problem;
  const GapCurvature c = hertzCase(6, 64, 64, true).gap;
  const Grid& grid = turned.patches[0].grid;
  turned.patches[0] = sampled(centredGrid(64, 256, grid.dy * grid.ny, grid.dx * grid.nx, true),
                              [c](double x, double y) { return c.b * x * x + c.a * y * y; });
  const NormalSolution steep = stripSolution(turned);
  // The difference comes from the rule across: strips are exact only along.
  EXPECT_NEAR(flat.approach / steep.approach, 1, 1e-4);
  EXPECT_NEAR(flat.patches[0].max_pressure / steep.patches[0].max_pressure, 1, 1e-3);
  EXPECT_NEAR(flat.patches[0].area / steep.patches[0].area, 1, 1e-3);
}

TEST(KikPiotrowski, DependsLittleOnTheBox)
{
  // The overlap of a 10:1 ellipse is wider than its contact, and wider than a close box.
  const double close = stripSolution(hertzCase(0.03, 32, 64, true, 1.05).problem).patches[0].max_pressure;
  const double wide = stripSolution(hertzCase(0.03, 32, 128, true, 2.1).problem).patches[0].max_pressure;
  EXPECT_NEAR(close / wide, 1, 2e-3);
}

/// Rail head whose arcs of 300 mm and 80 mm meet under the middle of the contact. A prototype of the method was 18 %
/// low in pressure and 3 % in approach, with an rms error of 18 %.
TEST(KikPiotrowski, UnderestimatesThePressureAtACurvatureJump)
{
  const auto discontinuity = [](double x, double y)
  { return wheel * x * x + 0.5 * (y < 1e-3 ? 1 / 0.3 - 1 / 0.9 : 1 / 0.08 - 1 / 0.9) * (y - 1e-3) * (y - 1e-3); };
  Grid grid = centredGrid(48, 64, 0.018, 0.014, true);
  grid.y0 -= 1.5e-3;
  const Deviation found = fromConjugateGradients(underLoad(sampled(grid, discontinuity), 1e5));
  EXPECT_LT(found.max_pressure, -0.05);
  EXPECT_GT(found.max_pressure, -0.30);
  EXPECT_LT(std::abs(found.approach), 0.08);
  EXPECT_LT(found.rms, 0.3);
}

TEST(KikPiotrowski, PressureFollowsShiftedStrips)
{
  // Columns are lowest at x = 0.3 y, which is the middle of the strips.
  const Grid grid = centredGrid(48, 48, 0.024, 0.024, false);
  const auto skewed = [](double x, double y) { return wheel * (x - 0.3 * y) * (x - 0.3 * y) + 2 * wheel * y * y; };
  const NormalSolution solution = stripSolution(underLoad(sampled(grid, skewed), 1e5));
  const Eigen::ArrayXXd& p = solution.patches[0].pressure;
  for (const int column : {20, 24, 28})
  {
    Eigen::Index row = 0;
    ASSERT_GT(p.col(column).maxCoeff(&row), 0);
    EXPECT_LT(std::abs(grid.x(static_cast<int>(row)) - 0.3 * grid.y(column)), grid.dx);
  }
}

// A box next to the deepest point: the gap decreases towards the edge and would decrease further.
TEST(KikPiotrowski, SolvesAGridThatCutsTheDeepestPoint)
{
  const Grid grid = centredGrid(16, 32, 0.02, 0.02, true);
  for (const double side : {-1.0, 1.0})
  {
    const auto falling = [side](double x, double y) { return wheel * x * x + 4 * y * y - 0.1 * side * y; };
    const NormalSolution solution = stripSolution(underLoad(sampled(grid, falling), 1e5));
    const Eigen::Index edge = side > 0 ? grid.ny - 1 : 0;
    EXPECT_TRUE(solution.patches[0].touches_border);
    EXPECT_GT(solution.patches[0].pressure.col(edge).maxCoeff(), 0.5 * solution.patches[0].max_pressure);
    EXPECT_TRUE(std::isfinite(solution.approach));
  }
}

// A light contact between the cells, none of which overlaps. The method has a solution, but its error cannot be
// estimated from the cells.
TEST(KikPiotrowski, EstimatesAnErrorOf100PercentIfNoCellOverlaps)
{
  const Grid grid = problems::centredGrid(8, 15, 8e-3, 15e-3, true);
  const NormalProblem problem =
      problems::underLoad(problems::sampled(grid, [](double x, double y) { return 40 * x * x + 1.1 * y * y; }), 100);
  KikPiotrowski solver;
  const NormalSolution solution = problems::solved(solver, problem);
  ASSERT_TRUE(isUsable(solution.status)) << toString(solution.status);
  ASSERT_LT(solution.approach, problem.patches[0].gap.minCoeff());
  ASSERT_GT(solution.patches[0].force, 0);
  EXPECT_EQ(errorsOf(solver, problem, solution)[0].largest(), 1);
}
}  // namespace
}  // namespace wheel_rail_contact::core
