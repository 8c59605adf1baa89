// SPDX-License-Identifier: BSD-3-Clause
// Patches that deform one another (CurvedProblem::coupling).
#include "../../seeded.h"
#include "core/constants.h"
#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
using problems::solvedCurved;

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
  problem.patches.push_back(problems::sampled(
      grid, [](double x, double y) { return bowl(y > 0, x, y > 0 ? y - half_distance : y + half_distance); }));
  return problems::atApproach(problem, approach);
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
  Seeded64 random(11);
  for (int scene = 0; scene < 10; ++scene)
  {
    CurvedProblem problem = randomCoupledProblem(random);
    const NormalSolution one = solvedCurved(problem);
    problem.patches[0].gap += 1e-5;
    problem.patches[1].gap *= 0.9;
    const NormalSolution other = solvedCurved(problem);
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
    const NormalSolution solution = solvedCurved(at(value));
    return 0.5 * work(at(value), solution, solution);
  };
  const NormalSolution middle = solvedCurved(at(approach));
  const double load = middle.patches[0].force + middle.patches[1].force;
  EXPECT_NEAR((energy(approach + step) - energy(approach - step)) / (2 * step) / load, 1, 1e-4);
}

// An ellipsoid of pressure of half-length a has the mean square a² / 5 along the track; a² is about half of that of the
// overlap. Without coupling the forces are too high by the mutual displacement, about a tenth of the approach.
TEST(PatchCoupling, DistantPatchesCarryTheForcesOfOneGridThatHoldsBoth)
{
  for (const double approach : {5e-5, 1e-4})
  {
    const auto whole = forcesOfHalves(solvedCurved(onOneGrid(approach)).patches[0]);
    CurvedProblem problem = onTwoGrids(approach);
    const NormalSolution apart = solvedCurved(problem);
    const double spread = std::sqrt(2 * 0.2 * 0.5 * approach / 1.1);
    couple(problem, spread, [](double here, double there) { return 2 * half_distance + there - here; });
    const NormalSolution coupled = solvedCurved(problem);
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
  const NormalSolution apart = solvedCurved(problem);
  couple(problem, 4e-3, [](double here, double there) { return 2 * half_distance + there - here; });
  const NormalSolution cold = solvedCurved(problem), warm = solvedCurved(problem, apart, true),
                       again = solvedCurved(problem, cold, true);
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
    EXPECT_EQ(solvedCurved(problem).status, SolveStatus::invalid_problem) << size;
  }
  problem.coupling.setZero(columns, 1);
  EXPECT_EQ(solvedCurved(problem).status, SolveStatus::invalid_problem);
  problem.coupling.setZero(columns, columns);
  EXPECT_EQ(solvedCurved(problem).status, SolveStatus::converged);
  problem.coupling(0, columns - 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solvedCurved(problem).status, SolveStatus::invalid_problem);
}
}  // namespace
}  // namespace wheel_rail_contact::core
