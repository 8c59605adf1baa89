// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/contact_tangent.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

#include "core/normal/solvers/conjugate_gradients.h"
#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr unsigned seed = 11;

NormalSolution solved(const CurvedProblem& problem)
{
  ConjugateGradientsOptions options;
  options.residual = 1e-9;
  NormalSolution solution;
  ConjugateGradients(options).solveCurved(problem, false, solution);
  return solution;
}

/// Openings by a displacement along the normals and by a rotation about x, in each column.
Eigen::ArrayXXd openingsOf(const CurvedProblem& problem, std::size_t k = 0)
{
  const PatchGap& patch = problem.patches[k];
  const Eigen::ArrayXd& weight = problem.normals[k].weight;
  Eigen::ArrayXXd openings(patch.grid.ny, 2);
  for (int j = 0; j < patch.grid.ny; ++j)
  {
    const double own = weight.size() > 0 ? weight[j] : 1;
    openings.row(j) << patch.weight * own, patch.grid.y(j);
  }
  return openings;
}

/// Stiffness of a problem with one patch, by a factorisation of the matrix of the loaded cells.
Eigen::MatrixXd denseStiffness(const CurvedProblem& problem, const NormalSolution& solution,
                               const Eigen::ArrayXXd& openings)
{
  const PatchGap& patch = problem.patches[0];
  const Eigen::MatrixXd all = problems::influenceMatrix(patch.grid, problem.modulus);
  std::vector<Eigen::Index> cells;
  for (Eigen::Index i = 0; i < patch.gap.size(); ++i)
  {
    if (solution.patches[0].pressure.data()[i] > 0)
    {
      cells.push_back(i);
    }
  }
  const auto n = static_cast<Eigen::Index>(cells.size());
  Eigen::MatrixXd matrix(n, n), right(n, openings.cols());
  const auto column = [&](Eigen::Index a) { return cells[static_cast<std::size_t>(a)] / patch.grid.rows(); };
  for (Eigen::Index a = 0; a < n; ++a)
  {
    right.row(a) = openings.row(column(a)).matrix();
    for (Eigen::Index b = 0; b < n; ++b)
    {
      const Eigen::ArrayXd& turns = problem.normals[0].turn;
      const double turn = turns.size() > 0 ? turns[column(a)] - turns[column(b)] : 0;
      matrix(a, b) = all(cells[static_cast<std::size_t>(a)], cells[static_cast<std::size_t>(b)]) * std::cos(turn);
    }
  }
  return patch.grid.cellArea() * right.transpose() * matrix.llt().solve(right);
}
}  // namespace

TEST(ContactTangent, AgreesWithAFactorisationOfTheMatrix)
{
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  for (int scene = 0; scene < 8; ++scene)
  {
    SCOPED_TRACE(scene);
    CurvedProblem problem = problems::curved(problems::randomProblem(random, 1));
    if (scene % 2 == 1)
    {
      problem.normals[0].turn = Eigen::ArrayXd::LinSpaced(problem.patches[0].grid.ny, -0.5, 0.4);
      problem.normals[0].weight = problem.normals[0].turn.cos();
    }
    const NormalSolution solution = solved(problem);
    const Eigen::ArrayXXd openings = openingsOf(problem);
    const Eigen::MatrixXd exact = denseStiffness(problem, solution, openings);
    const Eigen::MatrixXd found = ContactTangent(1e-8).stiffness(problem, solution, {openings});
    const double rotation = std::sqrt(exact(0, 0) * exact(1, 1));  // scale of the product of both displacements
    EXPECT_NEAR(found(0, 0) / exact(0, 0), 1, 1e-6);
    EXPECT_NEAR(found(1, 1) / exact(1, 1), 1, 1e-6);
    EXPECT_NEAR(found(0, 1) / rotation, exact(0, 1) / rotation, 1e-6);
    const Eigen::VectorXd column = ContactTangent(1e-8).stiffness(problem, solution, {openings}, 1);
    EXPECT_LT((column - found.col(1)).norm(), 1e-6 * rotation);
  }
}

// Hertz: F = k d^1.5, so dF/dd = 1.5 F / d. The cells at the edge carry pressure completely or not at all: 2 %.
TEST(ContactTangent, OfAHertzContactIsThreeHalvesOfTheSecantStiffness)
{
  const problems::HertzCase hertz = problems::hertzCase(1.5, 48, 48, true);
  const CurvedProblem problem = problems::curved(hertz.problem);
  const NormalSolution solution = solved(problem);
  ContactTangent tangent;
  const Eigen::MatrixXd stiffness =
      tangent.stiffness(problem, solution, {Eigen::ArrayXXd::Ones(problem.patches[0].grid.ny, 1)});
  EXPECT_NEAR(stiffness(0, 0) * solution.approach / (1.5 * solution.patches[0].force), 1, 0.02);
  EXPECT_LE(tangent.products(), 8);
}

TEST(ContactTangent, OfTwoPatchesIsTheSumOfBoth)
{
  std::mt19937_64 random(seed);
  const CurvedProblem both = problems::curved(problems::randomProblem(random, 2));
  const NormalSolution solution = solved(both);
  std::vector<Eigen::ArrayXXd> openings;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2, 2);
  for (std::size_t k = 0; k < 2; ++k)
  {
    openings.push_back(openingsOf(both, k));
    CurvedProblem one = both;
    one.patches = {both.patches[k]};
    one.normals = {both.normals[k]};
    NormalSolution part = solution;
    part.patches = {solution.patches[k]};
    sum += ContactTangent(1e-8).stiffness(one, part, {openings.back()});
  }
  const Eigen::MatrixXd found = ContactTangent(1e-8).stiffness(both, solution, openings);
  EXPECT_LT((found - sum).cwiseAbs().maxCoeff(), 1e-6 * sum.cwiseAbs().maxCoeff());
}
}  // namespace wheel_rail_contact::core
