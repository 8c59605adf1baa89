// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"

namespace wheel_rail_contact::core
{
namespace
{
using problems::hertzCase;

struct Errors
{
  double max_pressure = 0, highest_cell = 0, area = 0, counted_area = 0, approach = 0;
};

/// Largest relative errors on Hertz contacts of five shapes, with boxes of different margin and position.
Errors worstErrors(int nx, int ny)
{
  ConjugateGradients solver = problems::solverTo(1e-6);  // only the error of the cells remains
  Errors worst;
  for (const double ratio : {0.3, 1.0, 2.0, 5.0, 10.0})
  {
    for (const double margin : {1.1, 1.15, 1.2})
    {
      for (const double shift : {0.0, 0.2, 0.5})
      {
        const auto hertz = hertzCase(ratio, nx, ny, true, margin, shift);
        const NormalSolution solution = problems::solved(solver, hertz.problem);
        const PatchPressure& patch = solution.patches[0];
        const double counted = static_cast<double>((patch.pressure > 0).count()) * patch.grid.cellArea();
        const auto raise = [](double& largest, double found, double exact)
        { largest = std::max(largest, std::abs(found / exact - 1)); };
        raise(worst.max_pressure, patch.max_pressure, hertz.exact.max_pressure);
        raise(worst.highest_cell, patch.pressure.maxCoeff(), hertz.exact.max_pressure);
        raise(worst.area, patch.area, hertz.exact.area);
        raise(worst.counted_area, counted, hertz.exact.area);
        raise(worst.approach, solution.approach, hertz.exact.approach);
      }
    }
  }
  return worst;
}

// Tolerances: the worst case found, rounded up.
TEST(Measures, ErrorsOnHertzContactsFallWithTheCellsAndAreFarBelowThoseOfCountedAndHighestCells)
{
  const Errors coarse = worstErrors(8, 16), medium = worstErrors(16, 32), fine = worstErrors(32, 64);
  EXPECT_LT(coarse.area, 0.003);
  EXPECT_LT(medium.area, 0.00055);
  EXPECT_LT(fine.area, 0.00021);
  EXPECT_LT(medium.area, medium.counted_area / 70);
  EXPECT_LT(fine.area, fine.counted_area / 70);
  EXPECT_LT(coarse.max_pressure, 0.00076);
  EXPECT_LT(medium.max_pressure, 0.00021);
  EXPECT_LT(fine.max_pressure, 0.000041);
  EXPECT_LT(medium.max_pressure, 0.08 * medium.highest_cell);
  EXPECT_LT(fine.max_pressure, 0.08 * fine.highest_cell);
  EXPECT_LT(coarse.approach, 0.005);
  EXPECT_LT(medium.approach, 0.0015);
  EXPECT_LT(fine.approach, 0.0004);
}

/// Relative errors of area or highest pressure on Hertz contacts with A/B from 0.1 to 30, and boxes of any margin and
/// position.
std::vector<double> hertzErrors(double PatchPressure::*found, double HertzContact::*exact, int nx, int ny,
                                unsigned seed)
{
  ConjugateGradients solver = problems::solverTo(1e-6, 1000);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<double> errors;
  for (const double ratio : {0.1, 0.3, 1.0, 2.0, 5.0, 10.0, 30.0})
  {
    for (int k = 0; k < 15; ++k)
    {
      const double margin = 1.05 + 0.2 * part(random);
      const auto hertz = hertzCase(ratio, nx, ny, false, margin, part(random) - 0.5);
      const NormalSolution solution = problems::solved(solver, hertz.problem);
      errors.push_back(solution.patches[0].*found / hertz.exact.*exact - 1);
    }
  }
  return errors;
}

struct Limit
{
  int nx, ny;
  double of_most;  ///< limit for the error [-]
};

/// Expects that 95 of 100 errors are within the limit and that their mean is within a third of it.
void expectUnbiased(double PatchPressure::*found, double HertzContact::*exact, const std::vector<Limit>& limits)
{
  constexpr unsigned seed = 7;
  std::cout << "seed " << seed << "\n";
  for (const Limit& limit : limits)
  {
    const std::vector<double> errors = hertzErrors(found, exact, limit.nx, limit.ny, seed);
    double sum = 0;
    int within = 0;
    for (const double error : errors)
    {
      sum += error;
      within += std::abs(error) <= limit.of_most ? 1 : 0;
    }
    const auto count = static_cast<double>(errors.size());
    EXPECT_GE(within / count, 0.95) << limit.nx;
    EXPECT_LT(std::abs(sum / count), limit.of_most / 3) << limit.nx;
  }
}

// Tolerances: 98 % of 1400 contacts of another seed are below them. Without bias correction the crossings were too far
// out, and the mean error was 0.1 % on 24 × 56 cells.
TEST(Measures, AreaAndMaxPressureOfHertzContactsHaveNoBias)
{
  expectUnbiased(&PatchPressure::area, &HertzContact::area, {{12, 32, 9.1e-4}, {24, 56, 3.5e-4}, {40, 80, 2.3e-4}});
  // Tolerances: 98 % of 1400 contacts of another seed are below them. Without bias correction the mean error was 0.026
  // % on 24 × 56 cells.
  expectUnbiased(&PatchPressure::max_pressure, &HertzContact::max_pressure,
                 {{12, 32, 4.8e-4}, {24, 56, 1.1e-4}, {40, 80, 3.5e-5}});
}

// Tolerances for the difference between the largest and the smallest error. Without bias correction it was three times
// as large, because it depends on how far the edge extends beyond the outermost loaded rows and columns.
TEST(Measures, AreaHardlyDependsOnThePositionOfTheTips)
{
  ConjugateGradients solver = problems::solverTo(1e-6, 1000);
  for (const Limit& limit : {Limit{8, 16, 0.0047}, Limit{12, 32, 0.001}, Limit{16, 32, 0.0008}})
  {
    for (const double ratio : {0.3, 1.0, 3.0})
    {
      double least = 1, most = -1;
      for (int k = 0; k < 50; ++k)
      {
        const auto hertz = hertzCase(ratio, limit.nx, limit.ny, true, 1.03 + 0.004 * k, 0.3);
        const NormalSolution solution = problems::solved(solver, hertz.problem);
        const double error = solution.patches[0].area / hertz.exact.area - 1;
        least = std::min(least, error);
        most = std::max(most, error);
      }
      EXPECT_LT(most - least, limit.of_most) << limit.nx << " x " << limit.ny << ", ratio " << ratio;
    }
  }
}

TEST(Measures, AreaOfTwoLobesAgreesWithFourTimesFinerCells)
{
  const auto lobes = [](double x, double y)
  { return x * x / 0.92 + std::min((y + 5e-3) * (y + 5e-3) / 0.2, (y - 5e-3) * (y - 5e-3) / 0.12 + 2e-6); };
  ConjugateGradients solver;
  const auto area = [&](int factor)
  {
    const Grid grid = problems::centredGrid(16 * factor, 48 * factor, 0.017, 0.020, true);
    const NormalSolution solution = problems::solved(solver, problems::underLoad(problems::sampled(grid, lobes), 1e5));
    EXPECT_FALSE(solution.patches[0].touches_border);
    return solution.patches[0].area;
  };
  EXPECT_NEAR(area(1) / area(4), 1, 0.01);
}

TEST(Measures, ForceIsTheSumOfPressureTimesCellArea)
{
  const auto hertz = hertzCase(2, 16, 32, true);
  const NormalSolution solution = problems::solved(hertz.problem);
  const PatchPressure& patch = solution.patches[0];
  EXPECT_NEAR(patch.force / 1e5, 1, 1e-12);
  EXPECT_NEAR(patch.force / (patch.pressure.sum() * 2 * patch.grid.dx * patch.grid.dy), 1, 1e-12);
}
}  // namespace
}  // namespace wheel_rail_contact::core
