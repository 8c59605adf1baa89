// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>

#include "../../seeded.h"
#include "core/normal/solvers/contact_tangent.h"
#include "dense_active_set.h"

namespace wheel_rail_contact::core
{
// Patches whose columns have normals of their own, as on a curved surface.
namespace
{
using problems::solvedCurved;

/// Normals that turn by up to 1 rad over a patch, and the weights of a vertical load.
void turnColumns(std::mt19937_64& random, CurvedProblem& problem, std::size_t patch = 0)
{
  const double total = problems::uniform(random, -1, 1);
  const double middle = problems::uniform(random, -0.4, 0.4);
  ColumnNormals& normals = problem.normals[patch];
  normals.turn = Eigen::ArrayXd::LinSpaced(problem.patches[patch].grid.ny, middle - 0.5 * total, middle + 0.5 * total);
  normals.weight = normals.turn.cos();
}

/// A random patch.
class ColumnFields : public testing::Test
{
 protected:
  Seeded64 random_{7};
  CurvedProblem problem_ = problems::curved(problems::randomProblem(random_, 1));
};

void expectEqual(const CurvedProblem& problem, const NormalSolution& solution)
{
  ASSERT_EQ(solution.status, SolveStatus::converged);
  problems::DenseActiveSet dense(problem, problem.normals);
  const auto exact = dense.solve();
  EXPECT_NEAR(solution.approach / exact.approach, 1, 1e-7);
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    EXPECT_LE((solution.patches[k].pressure - exact.pressure[k]).abs().maxCoeff(), 1e-5 * exact.pressure[k].maxCoeff());
  }
}

// The residual of 1e-9 is relative to the overlap; the pressures of single cells differ by more.
TEST_F(ColumnFields, WeightsAndTurnedNormalsGiveTheExactSolution)
{
  for (int scene = 0; scene < 12; ++scene)
  {
    SCOPED_TRACE(scene);
    problem_ = problems::curved(problems::randomProblem(random_, 1 + scene % 2));
    for (std::size_t k = 0; k < problem_.patches.size(); ++k)
    {
      turnColumns(random_, problem_, k);
    }
    if (scene % 3 == 1)  // weights alone
    {
      problem_.normals[0].turn.resize(0);
    }
    if (scene % 3 == 2)  // turned normals alone
    {
      problem_.normals[0].weight.resize(0);
    }
    const NormalSolution solution = solvedCurved(problem_);
    expectEqual(problem_, solution);
    problem_ = problems::atApproach(problem_, solution.approach);
    expectEqual(problem_, solvedCurved(problem_));
  }
}

TEST_F(ColumnFields, ColumnsWithEqualNormalsAreOnePlane)
{
  const NormalSolution plane = solvedCurved(problem_);
  PatchGap& patch = problem_.patches[0];
  problem_.normals[0].turn = Eigen::ArrayXd::Constant(patch.grid.ny, 0.3);
  problem_.normals[0].weight = Eigen::ArrayXd::Constant(patch.grid.ny, 0.8);
  patch.weight /= 0.8;
  const NormalSolution turned = solvedCurved(problem_);
  EXPECT_NEAR(turned.approach / plane.approach, 1, 1e-8);
  EXPECT_LT(problems::difference(turned, plane), 1e-5);
}

TEST_F(ColumnFields, LoadIsTheWeightedSumOfTheForcesOfTheColumns)
{
  const NormalSolution first = solvedCurved(problem_);
  problem_.control = NormalProblem::Control::load;
  problem_.value = problem_.patches[0].weight * first.patches[0].force;
  PatchGap& patch = problem_.patches[0];
  turnColumns(random_, problem_);
  const NormalSolution solution = solvedCurved(problem_);
  const Eigen::ArrayXd columns = solution.patches[0].pressure.colwise().sum() * patch.grid.cellArea();
  EXPECT_NEAR(patch.weight * (columns * problem_.normals[0].weight).sum() / problem_.value, 1, 1e-9);
}

TEST_F(ColumnFields, AWarmStartGivesTheSameSolutionWithAtMostTwoProducts)
{
  turnColumns(random_, problem_);
  const NormalSolution cold = solvedCurved(problem_);
  const NormalSolution warm = solvedCurved(problem_, cold, true);
  EXPECT_LE(warm.iterations, 2);
  EXPECT_LT(problems::difference(warm, cold), 1e-6);
}

// The displacement of a plane patch does not belong to the turned one.
TEST_F(ColumnFields, AWarmStartFromThePlanePatchGivesTheTurnedSolution)
{
  const NormalSolution plane = solvedCurved(problem_);
  turnColumns(random_, problem_);
  problem_.normals[0].weight.resize(0);
  const NormalSolution cold = solvedCurved(problem_);
  const NormalSolution warm = solvedCurved(problem_, plane, true);
  EXPECT_GT(std::abs(cold.approach / plane.approach - 1) + std::abs(cold.patches[0].force / plane.patches[0].force - 1),
            1e-5);
  EXPECT_NEAR(warm.approach / cold.approach, 1, 1e-8);
  EXPECT_LT(problems::difference(warm, cold), 1e-5);
}

TEST_F(ColumnFields, WeightsOfAnotherNumberOfColumnsAreRefused)
{
  problem_.normals[0].weight = Eigen::ArrayXd::Ones(1);
  EXPECT_EQ(solvedCurved(problem_).status, SolveStatus::invalid_problem);
  problem_.normals[0].weight = Eigen::ArrayXd::Constant(problem_.patches[0].grid.ny, -1);
  EXPECT_EQ(solvedCurved(problem_).status, SolveStatus::invalid_problem);
  problem_.normals.resize(2);
  EXPECT_EQ(solvedCurved(problem_).status, SolveStatus::invalid_problem);
}

// Hertz, Kik-Piotrowski and Seidel solve the problem with one normal for each patch, and state this.
TEST_F(ColumnFields, OtherMethodsSayWhatTheyLeaveOut)
{
  problem_ = problems::curved(problems::hertzCase(2, 16, 32, true).problem);
  turnColumns(random_, problem_);
  for (const NormalMethod method : {NormalMethod::hertz, NormalMethod::kik_piotrowski, NormalMethod::seidel})
  {
    const auto solver = makeNormalSolver(method);
    NormalSolution on_curved, plane;
    solver->solveCurved(problem_, false, on_curved);
    solver->solve(static_cast<const NormalProblem&>(problem_), false, plane);
    EXPECT_EQ(on_curved.patches[0].max_pressure, plane.patches[0].max_pressure) << toString(method);
    EXPECT_EQ(solver->leftOut(problem_), "column normals") << toString(method);
  }
  EXPECT_EQ(ConjugateGradients().leftOut(problem_), "");
  problem_.patches.push_back(problem_.patches[0]);
  problem_.normals.push_back(problem_.normals[0]);
  problem_.coupling.setZero(64, 64);
  EXPECT_EQ(makeNormalSolver(NormalMethod::hertz)->leftOut(problem_), "column normals, patch coupling");
  problem_.normals.clear();
  EXPECT_EQ(makeNormalSolver(NormalMethod::seidel)->leftOut(problem_), "patch coupling");
}

constexpr unsigned seed = 11;

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
  const Eigen::ArrayXXd& pressure = solution.patches[0].pressure;
  const Eigen::VectorXd loaded =
      (Eigen::Map<const Eigen::ArrayXd>(pressure.data(), pressure.size()) > 0).cast<double>().matrix();
  Eigen::MatrixXd matrix = problems::influenceMatrix(patch.grid, problem.modulus),
                  right(loaded.size(), openings.cols());
  const Eigen::ArrayXd& turns = problem.normals[0].turn;
  for (Eigen::Index a = 0; a < loaded.size(); ++a)
  {
    const Eigen::Index column = a / patch.grid.rows();
    right.row(a) = loaded[a] * openings.row(column).matrix();
    for (Eigen::Index b = 0; b < loaded.size() && turns.size() > 0; ++b)
    {
      matrix(a, b) *= std::cos(turns[column] - turns[b / patch.grid.rows()]);
    }
  }
  return patch.grid.cellArea() * right.transpose() * problems::restricted(matrix, loaded).llt().solve(right);
}

TEST(ContactTangent, AgreesWithAFactorisationOfTheMatrix)
{
  Seeded64 random(seed);
  for (int scene = 0; scene < 8; ++scene)
  {
    SCOPED_TRACE(scene);
    CurvedProblem problem = problems::curved(problems::randomProblem(random, 1));
    if (scene % 2 == 1)
    {
      problem.normals[0].turn = Eigen::ArrayXd::LinSpaced(problem.patches[0].grid.ny, -0.5, 0.4);
      problem.normals[0].weight = problem.normals[0].turn.cos();
    }
    const NormalSolution solution = solvedCurved(problem);
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
  const NormalSolution solution = solvedCurved(problem);
  ContactTangent tangent;
  const Eigen::MatrixXd stiffness =
      tangent.stiffness(problem, solution, {Eigen::ArrayXXd::Ones(problem.patches[0].grid.ny, 1)});
  EXPECT_NEAR(stiffness(0, 0) * solution.approach / (1.5 * solution.patches[0].force), 1, 0.02);
  EXPECT_LE(tangent.products(), 8);
}

TEST(ContactTangent, OfTwoPatchesIsTheSumOfBoth)
{
  Seeded64 random(seed);
  const CurvedProblem both = problems::curved(problems::randomProblem(random, 2));
  const NormalSolution solution = solvedCurved(both);
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
}  // namespace
}  // namespace wheel_rail_contact::core
