// SPDX-License-Identifier: BSD-3-Clause
// Patches on a compliant support: same result as with the support fixed at the displacement that it reaches.
#include <gtest/gtest.h>

#include <random>

#include "core/normal/solvers/conjugate_gradients.h"
#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double strict_residual = 1e-9;

NormalSolution solved(const NormalProblem& problem)
{
  ConjugateGradientsOptions options;
  options.residual = strict_residual;
  NormalSolution solution;
  ConjugateGradients(options).solve(problem, false, solution);
  return solution;
}

/// Random problem on a support with random openings and compliance, about as soft as its contact. The gaps are given
/// for random coordinates of the support.
NormalProblem randomSupportedProblem(std::mt19937_64& random, int patches)
{
  NormalProblem problem = problems::randomProblem(random, patches);
  const NormalSolution stiff = solved(problem);
  double force = 0;
  double depth = 0;
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    PatchGap& patch = problem.patches[k];
    patch.opening.resize(patch.grid.ny, 3);
    for (Eigen::Index j = 0; j < patch.opening.rows(); ++j)
    {
      patch.opening.row(j) << problems::uniform(random, 0.5, 1), -patch.weight, problems::uniform(random, -0.3, 0.3);
    }
    force += stiff.patches[k].force;
    depth = std::max(depth, patch.weight * stiff.approach - patch.gap.minCoeff());
  }
  const double softness = problems::uniform(random, 0.1, 3) * depth / force;
  Eigen::Matrix3d root;
  root << 1, 0.2, 0.3, 0, 0.5, 0.1, 0, 0, 0.7;
  problem.support.compliant = true;
  problem.support.compliance = softness * root.transpose() * root;
  problem.support.placed = 0.1 * softness * force * Eigen::Vector3d(1, -1, 0.5);
  return problem;
}

Eigen::Vector3d forceOf(const NormalProblem& problem, const NormalSolution& solution)
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    const PatchGap& patch = problem.patches[k];
    const Eigen::RowVectorXd columns = solution.patches[k].pressure.matrix().colwise().sum();
    force += patch.grid.cellArea() * (columns * patch.opening.matrix()).transpose();
  }
  return force;
}

/// The same problem with the support fixed at `coordinates`.
NormalProblem held(NormalProblem problem, const Eigen::Vector3d& coordinates)
{
  for (PatchGap& patch : problem.patches)
  {
    const Eigen::VectorXd opened = patch.opening.matrix() * (coordinates - problem.support.placed);
    patch.gap.rowwise() += opened.array().transpose();
  }
  problem.support = Support();
  return problem;
}

class CompliantSupport : public testing::TestWithParam<int>
{
};
}  // namespace

TEST_P(CompliantSupport, DisplacementFollowsFromItsForces)
{
  std::mt19937_64 random(5);
  for (int scene = 0; scene < 40; ++scene)
  {
    const NormalProblem problem = randomSupportedProblem(random, GetParam());
    const NormalSolution solution = solved(problem);
    ASSERT_TRUE(isUsable(solution.status)) << "seed 5, scene " << scene << ": " << toString(solution.status);
    const Eigen::Vector3d due = problem.support.compliance * forceOf(problem, solution);
    EXPECT_LT((solution.support - due).norm(), 1e-12 * due.norm()) << "seed 5, scene " << scene;
  }
}

// The residual of both solutions is 1e-9 of the depth. At a given approach, a change of the gap changes the pressure at
// most in proportion to the depth over the smallest change by one cell of the edge. 1e-6 covers this here.
TEST_P(CompliantSupport, PressureEqualsThatOfAFixedSupport)
{
  std::mt19937_64 random(6);
  for (int scene = 0; scene < 40; ++scene)
  {
    const NormalProblem problem = randomSupportedProblem(random, GetParam());
    const NormalSolution solution = solved(problem);
    const NormalSolution reference = solved(held(problem, solution.support));
    ASSERT_TRUE(isUsable(solution.status) && isUsable(reference.status)) << "seed 6, scene " << scene;
    double highest = 0;
    for (const PatchPressure& patch : reference.patches)
    {
      highest = std::max(highest, patch.pressure.maxCoeff());
    }
    for (std::size_t k = 0; k < reference.patches.size(); ++k)
    {
      const double difference = (solution.patches[k].pressure - reference.patches[k].pressure).abs().maxCoeff();
      EXPECT_LT(difference, 1e-6 * highest) << "seed 6, scene " << scene << ", patch " << k;
    }
    EXPECT_NEAR(solution.approach / reference.approach, 1, 1e-6) << "seed 6, scene " << scene;
  }
}

TEST_P(CompliantSupport, WarmStartFromItsOwnResultTakesOneProduct)
{
  std::mt19937_64 random(7);
  for (int scene = 0; scene < 20; ++scene)
  {
    const NormalProblem problem = randomSupportedProblem(random, GetParam());
    ConjugateGradients solver;
    NormalSolution solution;
    solver.solve(problem, false, solution);
    ASSERT_TRUE(isUsable(solution.status)) << "seed 7, scene " << scene;
    solver.solve(problem, true, solution);
    EXPECT_LE(solution.iterations, 1) << "seed 7, scene " << scene;
  }
}

INSTANTIATE_TEST_SUITE_P(Patches, CompliantSupport, testing::Values(1, 2));

TEST(CompliantSupportCase, ZeroComplianceEqualsAFixedSupport)
{
  std::mt19937_64 random(8);
  NormalProblem problem = randomSupportedProblem(random, 1);
  problem.support.compliance.setZero();
  const NormalSolution solution = solved(problem);
  const NormalSolution reference = solved(held(problem, Eigen::Vector3d::Zero()));
  EXPECT_NEAR(solution.patches[0].pressure.maxCoeff() / reference.patches[0].pressure.maxCoeff(), 1, 1e-6);
  EXPECT_EQ(solution.support.norm(), 0);
}

TEST(CompliantSupportCase, OpeningOfTheWrongShapeIsAnInvalidProblem)
{
  std::mt19937_64 random(9);
  NormalProblem problem = randomSupportedProblem(random, 1);
  problem.patches[0].opening.conservativeResize(3, 3);
  EXPECT_EQ(solved(problem).status, SolveStatus::invalid_problem);
}

// The support is given in a position in which the bodies overlap. At rest it does not touch.
TEST(Support, ReportsNoContactIfTheSupportMovesAwayFromTheContact)
{
  problems::HertzCase hertz = problems::hertzCase(2, 16, 32, true);
  NormalProblem& problem = hertz.problem;
  problem.control = NormalProblem::Control::approach;
  problem.value = 40e-6;
  problem.patches[0].opening.setZero(problem.patches[0].grid.ny, 3);
  problem.patches[0].opening.col(0).setConstant(-1);
  problem.support.compliant = true;
  problem.support.compliance(0, 0) = 1e-8;
  for (const double placed : {1e-3, 41e-6})
  {
    problem.support.placed[0] = placed;
    const NormalSolution solution = solved(problem);
    EXPECT_EQ(solution.status, SolveStatus::no_contact) << placed;
    EXPECT_EQ(solution.patches[0].force, 0);
    EXPECT_TRUE(solution.support.isZero(0)) << solution.support;
  }
  problem.support.placed[0] = 30e-6;
  EXPECT_EQ(solved(problem).status, SolveStatus::converged);
}
}  // namespace wheel_rail_contact::core
