// SPDX-License-Identifier: BSD-3-Clause
#include "../../refusal.h"
#include "../../seeded.h"
#include "dense_active_set.h"

namespace wheel_rail_contact::core
{
namespace
{
using namespace problems;

/// Largest depth of interpenetration [m], the scale of the residual.
double depth(const NormalProblem& problem, double approach)
{
  double deepest = 0;
  for (const PatchGap& patch : problem.patches)
  {
    deepest = std::max(deepest, patch.weight * approach - patch.gap.minCoeff());
  }
  return deepest;
}

double loadOf(const NormalProblem& problem, const NormalSolution& solution)
{
  double load = 0;
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    load += problem.patches[k].weight * problem.patches[k].grid.cellArea() * solution.patches[k].pressure.sum();
  }
  return load;
}

class HertzCurvature : public testing::TestWithParam<double>
{
};

TEST_P(HertzCurvature, MaxPressureApproachAndAreaAreWithinATenthOfAPercent)
{
  for (const bool symmetric : {true, false})
  {
    const auto hertz = hertzCase(GetParam(), 32, 64, symmetric);
    const NormalSolution solution = solved(hertz.problem);
    ASSERT_EQ(solution.status, SolveStatus::converged);
    EXPECT_NEAR(solution.patches[0].max_pressure / hertz.exact.max_pressure, 1, 1e-3);
    EXPECT_NEAR(solution.approach / hertz.exact.approach, 1, 1e-3);
    EXPECT_NEAR(solution.patches[0].area / hertz.exact.area, 1, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Curvatures, HertzCurvature, testing::Values(1.0, 2.0, 5.0, 10.0, 0.2));

TEST(ConjugateGradients, AgreesWithTheDenseReference)
{
  Seeded64 random(11);
  ConjugateGradients solver = problems::solverTo(1e-9);
  for (int k = 0; k < 60; ++k)
  {
    const NormalProblem problem = randomProblem(random, 1 + k % 2);
    const NormalSolution solution = problems::converged(solver, problem);
    const DenseActiveSet::Result exact = DenseActiveSet(problem).solve();
    for (std::size_t p = 0; p < problem.patches.size(); ++p)
    {
      const double largest = exact.pressure[p].maxCoeff();
      EXPECT_LE((solution.patches[p].pressure - exact.pressure[p]).abs().maxCoeff(), 1e-6 * std::max(largest, 1e6))
          << "problem " << k << ", patch " << p;
    }
    EXPECT_NEAR(solution.approach, exact.approach, 1e-8 * depth(problem, exact.approach));
  }
}

TEST(ConjugateGradients, MeetsTheContactConditionsToTheStatedResidual)
{
  Seeded64 random(12);
  const ConjugateGradientsOptions options;
  ConjugateGradients solver(options);
  for (int k = 0; k < 100; ++k)
  {
    const NormalProblem problem = randomProblem(random, 1 + k % 3);
    const NormalSolution solution = problems::converged(solver, problem);
    const double allowed = options.residual * depth(problem, solution.approach);
    for (std::size_t p = 0; p < problem.patches.size(); ++p)
    {
      const PatchGap& patch = problem.patches[p];
      const Eigen::ArrayXXd& pressure = solution.patches[p].pressure;
      const Eigen::MatrixXd matrix = problems::influenceMatrix(patch.grid, problem.modulus);
      const Eigen::VectorXd displacement = matrix * Eigen::Map<const Eigen::VectorXd>(pressure.data(), pressure.size());
      const Eigen::ArrayXXd u =
          Eigen::Map<const Eigen::ArrayXXd>(displacement.data(), pressure.rows(), pressure.cols());
      const Eigen::ArrayXXd w = u + patch.gap - patch.weight * solution.approach;
      EXPECT_GE(pressure.minCoeff(), 0);
      EXPECT_GE(w.minCoeff(), -1.001 * allowed) << "problem " << k;
      EXPECT_LE((pressure > 0).select(w.abs(), 0.0).maxCoeff(), 1.001 * allowed) << "problem " << k;
      EXPECT_LE((solution.patches[p].displacement - u).abs().maxCoeff(), 1e-12 * u.maxCoeff());
    }
    if (problem.control == NormalProblem::Control::load)
    {
      EXPECT_NEAR(loadOf(problem, solution) / problem.value, 1, 1e-13) << "problem " << k;
    }
    EXPECT_LE(solution.residual, options.residual);
  }
}

TEST(ConjugateGradients, NeedsFewProducts)
{
  // These problems take 3 to 7 products from a cold start, and 2 to 5 from a neighbouring position.
  ConjugateGradients solver;
  for (const double ratio : {1.0, 2.0, 5.0, 10.0})
  {
    NormalSolution solution = solved(solver, hertzCase(ratio, 16, 32, true).problem);
    EXPECT_LE(solution.iterations, 8) << "ratio " << ratio;
    solver.solve(hertzCase(ratio, 16, 32, true, 1.1, 0.1).problem, true, solution);
    EXPECT_EQ(solution.status, SolveStatus::converged);
    EXPECT_LE(solution.iterations, 5) << "ratio " << ratio;
  }
}

TEST(ConjugateGradients, SymmetricGridGivesTheResultOfTheFullGrid)
{
  ConjugateGradients solver = problems::solverTo(1e-9);
  const NormalSolution full = solved(solver, hertzCase(3, 16, 24, false).problem);
  const NormalSolution half = solved(solver, hertzCase(3, 16, 24, true).problem);
  const double largest = full.patches[0].max_pressure;
  EXPECT_LE((full.patches[0].pressure.bottomRows(8) - half.patches[0].pressure).abs().maxCoeff(), 1e-7 * largest);
  EXPECT_LE((full.patches[0].pressure.topRows(8).colwise().reverse() - half.patches[0].pressure).abs().maxCoeff(),
            1e-7 * largest);
  EXPECT_NEAR(full.approach / half.approach, 1, 1e-9);
  EXPECT_NEAR(full.patches[0].area / half.patches[0].area, 1, 1e-6);
  EXPECT_NEAR(full.patches[0].force / half.patches[0].force, 1, 1e-12);
  EXPECT_NEAR(largest / half.patches[0].max_pressure, 1, 1e-7);
}

TEST(ConjugateGradients, WarmStartGivesTheColdResult)
{
  Seeded64 random(14);
  ConjugateGradients solver = problems::solverTo(1e-9);
  for (int k = 0; k < 40; ++k)
  {
    NormalProblem problem = randomProblem(random, 1 + k % 2);
    NormalSolution warm = solved(solver, problem);
    // The next message: another position, load and cell size. The cell aspects stay the same in half of the cases.
    for (PatchGap& patch : problem.patches)
    {
      patch.gap +=
          0.05 * patch.gap.maxCoeff() *
          Eigen::ArrayXXd::NullaryExpr(patch.gap.rows(), patch.gap.cols(), [&] { return uniform(random, 0, 1); });
      patch.grid.dx *= 1.03;
      patch.grid.dy *= k % 2 == 0 ? 1.03 : 1;
    }
    problem.value *= problem.control == NormalProblem::Control::load ? 1.1 : 1;
    solver.solve(problem, true, warm);
    const NormalSolution cold = solved(solver, problem);
    ASSERT_EQ(warm.status, cold.status) << "problem " << k;
    for (std::size_t p = 0; p < problem.patches.size(); ++p)
    {
      EXPECT_LE((warm.patches[p].pressure - cold.patches[p].pressure).abs().maxCoeff(),
                1e-6 * std::max(cold.patches[p].pressure.maxCoeff(), 1e6))
          << "problem " << k;
    }
  }
}

TEST(ConjugateGradients, SolvesAgainAfterThePressureWasChanged)
{
  ConjugateGradients solver;
  const auto hertz = hertzCase(2, 16, 32, true);
  NormalSolution solution = solved(solver, hertz.problem);
  const NormalSolution first = solution;
  solver.solve(hertz.problem, true, solution);
  EXPECT_EQ(solution.iterations, 0) << "already solved";
  solution.patches[0].pressure.leftCols(16) *= 0.7;
  solver.solve(hertz.problem, true, solution);
  EXPECT_GT(solution.iterations, 1);
  EXPECT_LE(problems::difference(solution, first), 1e-2);
  solution.patches[0].pressure.setConstant(std::numeric_limits<double>::quiet_NaN());
  solver.solve(hertz.problem, true, solution);
  EXPECT_EQ(solution.status, SolveStatus::converged);
}

TEST(ConjugateGradients, SolvesContactsOfOneToEightCells)
{
  ConjugateGradients solver = problems::solverTo(1e-9);
  int fewest = 1000;
  for (int k = 0; k < 40; ++k)
  {
    auto hertz = hertzCase(1.7, 8, 16, k % 2 == 0, 1.1, 0.3);
    hertz.problem.value *= std::pow(10, -0.2 * k);
    const NormalSolution solution = problems::converged(solver, hertz.problem);
    EXPECT_NEAR(loadOf(hertz.problem, solution) / hertz.problem.value, 1, 1e-13);
    const DenseActiveSet::Result exact = DenseActiveSet(hertz.problem).solve();
    EXPECT_LE((solution.patches[0].pressure - exact.pressure[0]).abs().maxCoeff(), 1e-7 * exact.pressure[0].maxCoeff())
        << "load " << hertz.problem.value << " N";
    fewest = std::min(fewest, static_cast<int>((solution.patches[0].pressure > 0).count()));
  }
  EXPECT_LE(fewest, 2);
}

// Status and flags of the solver, and the problems that it rejects.

/// Solution of a contact to a residual in at most `max_products` products.
NormalSolution solvedTo(double residual, int max_products)
{
  return solved(hertzCase(2, 16, 32, true).problem, residual, max_products);
}

TEST(ConjugateGradients, SeparatePatchCarriesNoLoad)
{
  NormalProblem problem = hertzCase(2, 16, 32, true).problem;
  problem.patches.push_back(problem.patches[0]);
  problem.patches[1].gap += 1e-3;
  const NormalSolution solution = solved(problem);
  ASSERT_EQ(solution.status, SolveStatus::converged);
  EXPECT_EQ(solution.patches[1].force, 0);
  EXPECT_EQ(solution.patches[1].area, 0);
  EXPECT_EQ(solution.patches[1].max_pressure, 0);
  EXPECT_FALSE(solution.patches[1].touches_border);
  EXPECT_NEAR(solution.patches[0].force, problem.value, 1e-9 * problem.value);
  const std::vector<ErrorEstimate> errors = errorsOf(ConjugateGradients(), problem, solution);
  EXPECT_EQ(errors[1].largest(), 0);
  EXPECT_GT(errors[0].largest(), 0);
}

TEST(ConjugateGradients, RejectsAnInvalidProblem)
{
  const auto status = [](auto spoil)
  {
    NormalProblem problem = hertzCase(2, 8, 16, true).problem;
    spoil(problem);
    return solved(problem).status;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(status([](NormalProblem&) {}), SolveStatus::converged);
  EXPECT_EQ(status([&](NormalProblem& p) { p.patches[0].gap(1, 2) = nan; }), SolveStatus::invalid_problem);
  EXPECT_EQ(status([&](NormalProblem& p) { p.patches[0].gap(1, 2) = -infinite; }), SolveStatus::invalid_problem);
  EXPECT_EQ(status([](NormalProblem& p) { p.patches.clear(); }), SolveStatus::invalid_problem);
  EXPECT_EQ(status([](NormalProblem& p) { p.patches[0].gap.resize(3, 3); }), SolveStatus::invalid_problem);
  EXPECT_EQ(status([](NormalProblem& p) { p.patches[0].grid.dx = 0; }), SolveStatus::invalid_problem);
  EXPECT_EQ(status([](NormalProblem& p) { p.patches[0].weight = 0; }), SolveStatus::invalid_problem);
  EXPECT_EQ(status([](NormalProblem& p) { p.modulus = 0; }), SolveStatus::invalid_problem);
  EXPECT_EQ(status([](NormalProblem& p) { p.value = 0; }), SolveStatus::invalid_problem);
  EXPECT_EQ(status([&](NormalProblem& p) { p.value = nan; }), SolveStatus::invalid_problem);
}

TEST(ConjugateGradients, ReportsTheIterationLimitAndAStalledResidual)
{
  NormalSolution solution = solvedTo(1e-9, 3);
  EXPECT_EQ(solution.status, SolveStatus::iteration_limit);
  EXPECT_FALSE(isUsable(solution.status));
  // Rounding leaves a residual of about 1e-16, which further products do not decrease.
  solution = solvedTo(1e-18, 100000);
  EXPECT_EQ(solution.status, SolveStatus::stalled);
  EXPECT_FALSE(isUsable(solution.status));
  EXPECT_LT(solution.residual, 1e-12);
}

// Two patches that pull one another farther than they deflect: the energy falls without limit.
TEST(ConjugateGradients, RejectsAnIndefiniteMatrix)
{
  CurvedProblem problem = problems::curved(hertzCase(2, 16, 32, true).problem);
  problem.patches.push_back(problem.patches[0]);
  problem.normals.clear();
  const int columns = problem.patches[0].grid.ny;
  problem.coupling.setZero(2 * columns, 2 * columns);
  problem.coupling.topRightCorner(columns, columns).setConstant(-1e-6);
  problem.coupling.bottomLeftCorner(columns, columns).setConstant(-1e-6);
  ConjugateGradients solver;
  NormalSolution solution;
  solver.solveCurved(problem, false, solution);  // a given load bounds the energy
  EXPECT_FALSE(isUsable(solution.status));
  problem.control = NormalProblem::Control::approach;
  problem.value = 1e-4;
  solver.solveCurved(problem, false, solution);
  EXPECT_EQ(solution.status, SolveStatus::indefinite);
  EXPECT_EQ(solution.iterations, 2);
}

TEST(ConjugateGradients, RejectsInvalidOptionsByName)
{
  const auto message = [](double residual, int max_products)
  { return refusalOf([=] { problems::solverTo(residual, max_products); }); };
  EXPECT_EQ(message(1e-4, 10), "accepted");
  EXPECT_EQ(message(0, 10), "residual = 0.000000: must be in (0, 1)");
  EXPECT_EQ(message(1e-4, 0), "max_products = 0: must be positive");
}

TEST(ContactModulus, IsTheCombinationOfBothBodies)
{
  Material steel, rubber;
  rubber.young = 1e7;
  rubber.poisson = 0.5;
  EXPECT_NEAR(contactModulus(steel, steel) / (0.5 * 2.1e11 / (1 - 0.28 * 0.28)), 1, 1e-14);
  EXPECT_NEAR(contactModulus(steel, rubber) / (1e7 / 0.75), 1, 1e-4);
  rubber.poisson = 0.6;
  EXPECT_THROW(contactModulus(steel, rubber), std::invalid_argument);
  rubber.poisson = 0.4;
  rubber.young = 0;
  EXPECT_THROW(contactModulus(steel, rubber), std::invalid_argument);
}
}  // namespace
}  // namespace wheel_rail_contact::core
