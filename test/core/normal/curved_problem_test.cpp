// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>

#include "../../seeded.h"
#include "core/constants.h"
#include "core/normal/solvers/contact_tangent.h"
#include "dense_active_set.h"

namespace wheel_rail_contact::core
{
// Patches whose columns have normals of their own, as on a curved surface.
namespace
{
constexpr double strict_residual = 1e-9;
constexpr unsigned column_seed = 7;

NormalSolution solved(const CurvedProblem& problem, NormalSolution solution = {}, bool warm = false)
{
  problems::solverTo(strict_residual).solveCurved(problem, warm, solution);
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

// The residual of 1e-9 is relative to the overlap; the pressures of single cells differ by more.
TEST(ColumnFields, WeightsAndTurnedNormalsGiveTheExactSolution)
{
  Seeded64 random(column_seed);
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
  Seeded64 random(column_seed);
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
  Seeded64 random(column_seed);
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
  Seeded64 random(column_seed);
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
  Seeded64 random(column_seed);
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
  Seeded64 random(column_seed);
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
  Seeded64 random(column_seed);
  CurvedProblem problem = problems::curved(problems::hertzCase(2, 16, 32, true).problem);
  turnColumns(random, problem);
  for (const NormalMethod method : {NormalMethod::hertz, NormalMethod::kik_piotrowski, NormalMethod::seidel})
  {
    const auto solver = makeNormalSolver(method);
    NormalSolution on_curved, plane;
    solver->solveCurved(problem, false, on_curved);
    solver->solve(static_cast<const NormalProblem&>(problem), false, plane);
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
  Seeded64 random(seed);
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

// Patches that deform one another (CurvedProblem::coupling).

/// Displacement of each column of two patches by the forces in the columns of the other: that of a point force on a
/// half-space (Johnson 1985, eq. 3.22b), at the root of `distance`² + `spread`² [m].
template <typename Distance>
void couple(CurvedProblem& problem, double spread, Distance distance)
{
  const Grid &one = problem.patches[0].grid, &other = problem.patches[1].grid;
  problem.coupling.setZero(one.ny + other.ny, one.ny + other.ny);
  for (int i = 0; i < one.ny; ++i)
  {
    for (int j = 0; j < other.ny; ++j)
    {
      const double away = std::hypot(distance(one.y(i), other.y(j)), spread);
      problem.coupling(i, one.ny + j) = problem.coupling(one.ny + j, i) = 1 / (pi * problem.modulus * away);
    }
  }
}

/// Two random patches 20 mm apart, with weights and normals of their own columns.
CurvedProblem randomCoupledProblem(std::mt19937_64& random)
{
  CurvedProblem problem = problems::curved(problems::randomProblem(random, 2));
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    ColumnNormals& normals = problem.normals[k];
    normals.turn = Eigen::ArrayXd::LinSpaced(problem.patches[k].grid.ny, -0.2, problems::uniform(random, 0, 0.4));
    normals.weight = normals.turn.cos();
  }
  couple(problem, 3e-3, [](double here, double there) { return 0.02 + there - here; });
  return problem;
}

/// Work of the pressures of one solution on the displacements of another [J].
double work(const NormalProblem& problem, const NormalSolution& pressures, const NormalSolution& displacements)
{
  double sum = 0;
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    const Eigen::ArrayXXd product = pressures.patches[k].pressure * displacements.patches[k].displacement;
    sum += problem.patches[k].grid.cellArea() * product.sum();
  }
  return sum;
}

/// Two bowls whose lowest points are 12 mm apart, at y = -6 mm and y = 6 mm, of different curvature and height.
constexpr double half_distance = 6e-3;  ///< [m]

double bowl(bool second, double x, double y)
{
  return second ? 1.1 * x * x + 40 * y * y + 1e-5 : 1.1 * x * x + 25 * y * y;
}

/// One grid that holds both bowls.
CurvedProblem onOneGrid(double approach)
{
  const Grid grid = problems::centredGrid(64, 240, 0.024, 0.024, true);
  CurvedProblem problem;
  problem.modulus = problems::steel();
  problem.control = NormalProblem::Control::approach;
  problem.value = approach;
  problem.patches.push_back(problems::sampled(
      grid, [](double x, double y) { return bowl(y > 0, x, y > 0 ? y - half_distance : y + half_distance); }));
  return problem;
}

/// The same cells around each bowl, as two patches. y is measured from the lowest point of each.
CurvedProblem onTwoGrids(double approach)
{
  const Grid grid = problems::centredGrid(64, 80, 0.024, 0.008, true);
  CurvedProblem problem = onOneGrid(approach);
  problem.patches = {problems::sampled(grid, [](double x, double y) { return bowl(false, x, y); }),
                     problems::sampled(grid, [](double x, double y) { return bowl(true, x, y); })};
  return problem;
}

/// Normal forces on a grid below and above y = 0 [N].
std::array<double, 2> forcesOfHalves(const PatchPressure& patch)
{
  const Eigen::Index half = patch.pressure.cols() / 2;
  const double area = patch.grid.cellArea();
  return {area * patch.pressure.leftCols(half).sum(), area * patch.pressure.rightCols(half).sum()};
}

// The work of one pressure on the displacements by another is the work of the other on the displacements by the first.
// Tolerance: the solution keeps its displacement from step to step.
TEST(PatchCoupling, WorkOfTwoPressuresIsSymmetric)
{
  Seeded64 random(seed);
  for (int scene = 0; scene < 10; ++scene)
  {
    CurvedProblem problem = randomCoupledProblem(random);
    const NormalSolution one = solved(problem);
    problem.patches[0].gap += 1e-5;
    problem.patches[1].gap *= 0.9;
    const NormalSolution other = solved(problem);
    ASSERT_TRUE(isUsable(one.status) && isUsable(other.status)) << "scene " << scene;
    const double forward = work(problem, one, other);
    EXPECT_GT(forward, 0) << "scene " << scene;
    EXPECT_NEAR(work(problem, other, one) / forward, 1, 1e-10) << "scene " << scene;
  }
}

// The load is the derivative of the energy with respect to the approach. Central differences over 1 % of the approach.
TEST(PatchCoupling, LoadIsTheDerivativeOfTheEnergy)
{
  constexpr double approach = 1e-4, step = 5e-7;
  const auto at = [](double value)
  {
    CurvedProblem problem = onTwoGrids(value);
    couple(problem, 4e-3, [](double here, double there) { return 2 * half_distance + there - here; });
    return problem;
  };
  const auto energy = [&](double value)
  {
    const NormalSolution solution = solved(at(value));
    return 0.5 * work(at(value), solution, solution);
  };
  const NormalSolution middle = solved(at(approach));
  const double load = middle.patches[0].force + middle.patches[1].force;
  EXPECT_NEAR((energy(approach + step) - energy(approach - step)) / (2 * step) / load, 1, 1e-4);
}

// An ellipsoid of pressure of half-length a has the mean square a² / 5 along the track; a² is about half of that of the
// overlap. Without coupling the forces are too high by the mutual displacement, about a tenth of the approach.
TEST(PatchCoupling, DistantPatchesCarryTheForcesOfOneGridThatHoldsBoth)
{
  for (const double approach : {5e-5, 1e-4})
  {
    const auto whole = forcesOfHalves(solved(onOneGrid(approach)).patches[0]);
    CurvedProblem problem = onTwoGrids(approach);
    const NormalSolution apart = solved(problem);
    const double spread = std::sqrt(2 * 0.2 * 0.5 * approach / 1.1);
    couple(problem, spread, [](double here, double there) { return 2 * half_distance + there - here; });
    const NormalSolution coupled = solved(problem);
    for (std::size_t k = 0; k < 2; ++k)
    {
      std::cout << "approach " << approach << ", patch " << k << ": " << coupled.patches[k].force / whole[k] - 1
                << " with coupling, " << apart.patches[k].force / whole[k] - 1 << " without\n";
      EXPECT_NEAR(coupled.patches[k].force / whole[k], 1, 0.01) << "patch " << k;
      EXPECT_GT(apart.patches[k].force / whole[k], 1.05) << "patch " << k;
    }
  }
}

// An earlier displacement without coupling does not belong to the coupled problem.
TEST(PatchCoupling, AWarmStartFromTheUncoupledSolutionGivesTheCoupledOne)
{
  CurvedProblem problem = onTwoGrids(1e-4);
  const NormalSolution apart = solved(problem);
  couple(problem, 4e-3, [](double here, double there) { return 2 * half_distance + there - here; });
  const NormalSolution cold = solved(problem), warm = solved(problem, apart, true), again = solved(problem, cold, true);
  for (std::size_t k = 0; k < 2; ++k)
  {
    EXPECT_LT(cold.patches[k].force / apart.patches[k].force, 0.95);
    EXPECT_NEAR(warm.patches[k].force / cold.patches[k].force, 1, 1e-7);
    EXPECT_NEAR(again.patches[k].force / cold.patches[k].force, 1, 1e-7);
  }
  EXPECT_LE(again.iterations, 2);
}

TEST(PatchCoupling, ACouplingOfTheWrongSizeIsAnInvalidProblem)
{
  CurvedProblem problem = onTwoGrids(1e-4);
  const Eigen::Index columns = 2 * problem.patches[0].grid.ny;
  for (const Eigen::Index size : {Eigen::Index{1}, columns - 1, columns + 1})
  {
    problem.coupling.setZero(size, size);
    EXPECT_EQ(solved(problem).status, SolveStatus::invalid_problem) << size;
  }
  problem.coupling.setZero(columns, 1);
  EXPECT_EQ(solved(problem).status, SolveStatus::invalid_problem);
  problem.coupling.setZero(columns, columns);
  EXPECT_EQ(solved(problem).status, SolveStatus::converged);
  problem.coupling(0, columns - 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solved(problem).status, SolveStatus::invalid_problem);
}
}  // namespace
}  // namespace wheel_rail_contact::core
