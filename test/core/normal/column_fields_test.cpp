// SPDX-License-Identifier: BSD-3-Clause
// Patches whose columns have normals of their own, as on a curved surface.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "core/normal/solvers/conjugate_gradients.h"
#include "dense_active_set.h"
#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double strict_residual = 1e-9;
constexpr unsigned seed = 7;

NormalSolution solved(const CurvedProblem& problem, NormalSolution solution = {}, bool warm = false)
{
  ConjugateGradientsOptions options;
  options.residual = strict_residual;
  ConjugateGradients(options).solveCurved(problem, warm, solution);
  return solution;
}

/// Normals that turn by up to 1 rad over a patch, and the weights of a vertical load.
void turnColumns(std::mt19937_64& random, CurvedProblem& problem, std::size_t patch = 0)
{
  const double total = problems::uniform(random, -1, 1);
  const double middle = problems::uniform(random, -0.4, 0.4);
  ColumnNormals& normals = problem.normals[patch];
  normals.turn = Eigen::ArrayXd::LinSpaced(problem.patches[patch].grid.ny, middle - 0.5 * total, middle + 0.5 * total);
  normals.weight = normals.turn.cos();
}

void expectEqual(const CurvedProblem& problem, const NormalSolution& solution)
{
  ASSERT_EQ(solution.status, SolveStatus::converged);
  problems::DenseActiveSet dense(problem, problem.normals);
  const auto exact = dense.solve();
  EXPECT_NEAR(solution.approach / exact.approach, 1, 1e-7);
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    const double highest = exact.pressure[k].maxCoeff();
    EXPECT_LE((solution.patches[k].pressure - exact.pressure[k]).abs().maxCoeff(), 1e-5 * highest);
  }
}
}  // namespace

// The residual of 1e-9 is relative to the overlap; the pressures of single cells differ by more.
TEST(ColumnFields, WeightsAndTurnedNormalsGiveTheExactSolution)
{
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  for (int scene = 0; scene < 12; ++scene)
  {
    SCOPED_TRACE(scene);
    CurvedProblem problem = problems::curved(problems::randomProblem(random, 1 + scene % 2));
    for (std::size_t k = 0; k < problem.patches.size(); ++k)
    {
      turnColumns(random, problem, k);
    }
    if (scene % 3 == 1)  // weights alone
    {
      problem.normals[0].turn.resize(0);
    }
    if (scene % 3 == 2)  // turned normals alone
    {
      problem.normals[0].weight.resize(0);
    }
    const NormalSolution solution = solved(problem);
    expectEqual(problem, solution);
    problem.control = NormalProblem::Control::approach;
    problem.value = solution.approach;
    expectEqual(problem, solved(problem));
  }
}

TEST(ColumnFields, ColumnsWithEqualNormalsAreOnePlane)
{
  std::mt19937_64 random(seed);
  CurvedProblem problem = problems::curved(problems::randomProblem(random, 1));
  const NormalSolution plane = solved(problem);
  PatchGap& patch = problem.patches[0];
  problem.normals[0].turn = Eigen::ArrayXd::Constant(patch.grid.ny, 0.3);
  problem.normals[0].weight = Eigen::ArrayXd::Constant(patch.grid.ny, 0.8);
  patch.weight /= 0.8;
  const NormalSolution turned = solved(problem);
  EXPECT_NEAR(turned.approach / plane.approach, 1, 1e-8);
  EXPECT_LT((turned.patches[0].pressure - plane.patches[0].pressure).abs().maxCoeff(),
            1e-5 * plane.patches[0].max_pressure);
}

TEST(ColumnFields, LoadIsTheWeightedSumOfTheForcesOfTheColumns)
{
  std::mt19937_64 random(seed);
  CurvedProblem problem = problems::curved(problems::randomProblem(random, 1));
  const NormalSolution first = solved(problem);
  problem.control = NormalProblem::Control::load;
  problem.value = problem.patches[0].weight * first.patches[0].force;
  PatchGap& patch = problem.patches[0];
  turnColumns(random, problem);
  const NormalSolution solution = solved(problem);
  const Eigen::ArrayXd columns = solution.patches[0].pressure.colwise().sum() * patch.grid.cellArea();
  EXPECT_NEAR(patch.weight * (columns * problem.normals[0].weight).sum() / problem.value, 1, 1e-9);
}

TEST(ColumnFields, AWarmStartGivesTheSameSolutionWithAtMostTwoProducts)
{
  std::mt19937_64 random(seed);
  CurvedProblem problem = problems::curved(problems::randomProblem(random, 1));
  turnColumns(random, problem);
  const NormalSolution cold = solved(problem);
  const NormalSolution warm = solved(problem, cold, true);
  EXPECT_LE(warm.iterations, 2);
  EXPECT_LT((warm.patches[0].pressure - cold.patches[0].pressure).abs().maxCoeff(),
            1e-6 * cold.patches[0].max_pressure);
}

// The displacement of a plane patch does not belong to the turned one.
TEST(ColumnFields, AWarmStartFromThePlanePatchGivesTheTurnedSolution)
{
  std::mt19937_64 random(seed);
  CurvedProblem problem = problems::curved(problems::randomProblem(random, 1));
  const NormalSolution plane = solved(problem);
  turnColumns(random, problem);
  problem.normals[0].weight.resize(0);
  const NormalSolution cold = solved(problem);
  const NormalSolution warm = solved(problem, plane, true);
  EXPECT_GT(std::abs(cold.approach / plane.approach - 1) + std::abs(cold.patches[0].force / plane.patches[0].force - 1),
            1e-5);
  EXPECT_NEAR(warm.approach / cold.approach, 1, 1e-8);
  EXPECT_LT((warm.patches[0].pressure - cold.patches[0].pressure).abs().maxCoeff(),
            1e-5 * cold.patches[0].max_pressure);
}

TEST(ColumnFields, WeightsOfAnotherNumberOfColumnsAreRefused)
{
  std::mt19937_64 random(seed);
  CurvedProblem problem = problems::curved(problems::randomProblem(random, 1));
  problem.normals[0].weight = Eigen::ArrayXd::Ones(1);
  EXPECT_EQ(solved(problem).status, SolveStatus::invalid_problem);
  problem.normals[0].weight = Eigen::ArrayXd::Constant(problem.patches[0].grid.ny, -1);
  EXPECT_EQ(solved(problem).status, SolveStatus::invalid_problem);
  problem.normals.resize(2);
  EXPECT_EQ(solved(problem).status, SolveStatus::invalid_problem);
}

// Hertz, Kik-Piotrowski and Seidel solve the problem with one normal for each patch, and state this.
TEST(ColumnFields, OtherMethodsSayWhatTheyLeaveOut)
{
  std::mt19937_64 random(seed);
  CurvedProblem problem = problems::curved(problems::hertzCase(2, 16, 32, true).problem);
  turnColumns(random, problem);
  for (const NormalMethod method : {NormalMethod::hertz, NormalMethod::kik_piotrowski, NormalMethod::seidel})
  {
    const auto solver = makeNormalSolver(method);
    NormalSolution on_curved, plane;
    solver->solveCurved(problem, false, on_curved);
    solver->solve(problem, false, plane);
    EXPECT_EQ(on_curved.patches[0].max_pressure, plane.patches[0].max_pressure) << toString(method);
    EXPECT_EQ(solver->leftOut(problem), "column normals") << toString(method);
  }
  EXPECT_EQ(ConjugateGradients().leftOut(problem), "");
  problem.patches.push_back(problem.patches[0]);
  problem.normals.push_back(problem.normals[0]);
  problem.coupling.setZero(64, 64);
  EXPECT_EQ(makeNormalSolver(NormalMethod::hertz)->leftOut(problem), "column normals, patch coupling");
  problem.normals.clear();
  EXPECT_EQ(makeNormalSolver(NormalMethod::seidel)->leftOut(problem), "patch coupling");
}
}  // namespace wheel_rail_contact::core
