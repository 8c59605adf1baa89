// SPDX-License-Identifier: BSD-3-Clause
// Status and flags of the solver, and the problems that it rejects.
#include "core/normal/solvers/conjugate_gradients.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
using problems::hertzCase;

NormalSolution solved(const NormalProblem& problem, const ConjugateGradientsOptions& options = {})
{
  NormalSolution solution;
  ConjugateGradients(options).solve(problem, false, solution);
  return solution;
}

/// Solution of a contact to a residual in at most `max_products` products.
NormalSolution solvedTo(double residual, int max_products)
{
  ConjugateGradientsOptions options;
  options.residual = residual;
  options.max_products = max_products;
  return solved(hertzCase(2, 16, 32, true).problem, options);
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
}

TEST(ConjugateGradients, FlagsABoxThatCutsThePatch)
{
  for (const bool symmetric : {true, false})
  {
    EXPECT_TRUE(solved(hertzCase(2, 16, 32, symmetric, 0.9).problem).patches[0].touches_border);
    EXPECT_FALSE(solved(hertzCase(2, 16, 32, symmetric, 1.2).problem).patches[0].touches_border);
    EXPECT_TRUE(solved(hertzCase(2, 16, 32, symmetric, 1.2, 5).problem).patches[0].touches_border)
        << "cut on one side only";
  }
}

TEST(ConjugateGradients, ReportsNoContactAtASmallApproach)
{
  auto hertz = hertzCase(2, 16, 32, true);
  hertz.problem.control = NormalProblem::Control::approach;
  hertz.problem.value = 0.999 * hertz.problem.patches[0].gap.minCoeff();
  const NormalSolution solution = solved(hertz.problem);
  EXPECT_EQ(solution.status, SolveStatus::no_contact);
  EXPECT_TRUE(isUsable(solution.status));
  EXPECT_EQ(solution.patches[0].force, 0);
  EXPECT_EQ(solution.patches[0].pressure.maxCoeff(), 0);
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

TEST(ConjugateGradients, ReportsTheIterationLimit)
{
  const NormalSolution solution = solvedTo(1e-9, 3);
  EXPECT_EQ(solution.status, SolveStatus::iteration_limit);
  EXPECT_FALSE(isUsable(solution.status));
}

// Rounding leaves a residual of about 1e-16, which further products do not decrease.
TEST(ConjugateGradients, ReportsAStalledResidual)
{
  const NormalSolution solution = solvedTo(1e-18, 100000);
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
  solver.solveCurved(problem, false, solution);
  EXPECT_EQ(solution.status, SolveStatus::indefinite);
  EXPECT_FALSE(isUsable(solution.status));
}

TEST(ConjugateGradients, RejectsInvalidOptionsByName)
{
  const auto message = [](double residual, int max_products) -> std::string
  {
    try
    {
      ConjugateGradientsOptions options;
      options.residual = residual;
      options.max_products = max_products;
      ConjugateGradients solver(options);
      return "accepted";
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
  };
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
