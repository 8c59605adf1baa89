// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/pressure_measures.h"

#include "core/constants.h"
#include "core/normal/measures/gap_steps.h"
#include "error_samples.h"

using namespace wheel_rail_contact::core;

namespace
{
struct Pressures
{
  double raised = 0, highest_cell = 0;
};

/// Largest errors of the highest pressure over ten positions of a gap among its cells, against cells eight times finer.
/// `gap(x, y)` is shifted by parts of a cell.
template <typename Gap>
Pressures largestErrors(const Grid& grid, double load, const Gap& gap)
{
  ConjugateGradients solver = problems::solverTo(1e-6, 1000);
  Pressures worst;
  for (int place = 0; place < 10; ++place)
  {
    const double shift = 0.1 * place * grid.dy;
    const auto moved = [&](double x, double y) { return gap(x, y - shift); };
    const auto on = [&](const Grid& cells)
    { return problems::solved(solver, problems::underLoad(problems::sampled(cells, moved), load)); };
    const NormalSolution found = on(grid), fine = on(scenes::refined(grid, 8));
    EXPECT_TRUE(found.status == SolveStatus::converged && fine.status == SolveStatus::converged);
    EXPECT_FALSE(found.patches[0].touches_border);
    const double truth = fine.patches[0].max_pressure;
    worst.raised = std::max(worst.raised, std::abs(found.patches[0].max_pressure / truth - 1));
    worst.highest_cell = std::max(worst.highest_cell, std::abs(found.patches[0].pressure.maxCoeff() / truth - 1));
  }
  return worst;
}

/// A wheel of 0.46 m radius on a crown that joins a shoulder: the pressure is highest next to the discontinuity.
double shoulder(double x, double y)
{
  return x * x / 0.92 + y * y / (y > 0 ? 0.1 : 0.8);
}

/// The same between two shoulders, with two pressure peaks.
double lobes(double x, double y)
{
  constexpr double width = 7e-3;  // between the discontinuities [m]
  const double beyond = std::max({y, -width - y, 0.0});
  return x * x / 0.92 + y * y / 3 + beyond * beyond / 0.15;
}

// Tolerances: the largest error found (0.51 and 0.78 %, 0.13 and 0.14 %; of the highest cell 4.0 and 4.7 %, 0.89 and
// 0.93 %), rounded up.
TEST(PeakPressure, AgreesWithEightTimesFinerCellsNextToADiscontinuity)
{
  struct Limit
  {
    int nx, ny;
    double error, over_cell;
  };
  for (const Limit& limit : {Limit{12, 32, 0.008, 0.17}, Limit{24, 64, 0.0014, 0.15}})
  {
    const std::vector<Pressures> scenes{
        largestErrors(problems::centredGrid(limit.nx, limit.ny, 0.018, 0.026, true), 1e5, shoulder),
        largestErrors(problems::centredGrid(limit.nx, limit.ny, 0.019, 0.030, true), 1e5, lobes)};
    for (const Pressures& errors : scenes)
    {
      EXPECT_LT(errors.raised, limit.error) << limit.nx << " x " << limit.ny;
      EXPECT_LT(errors.raised, limit.over_cell * errors.highest_cell) << limit.nx << " x " << limit.ny;
    }
  }
}

// A peak need not be at a cell: it exceeds two equal cells next to it.
TEST(PeakPressure, LiesBetweenTwoEqualCells)
{
  const auto hertz = problems::hertzCase(2, 16, 32, true);
  ConjugateGradients solver = problems::solverTo(1e-8);
  const NormalSolution solution = problems::solved(solver, hertz.problem);
  const Eigen::ArrayXXd& p = solution.patches[0].pressure;
  ASSERT_NEAR(p(0, 15) / p(0, 16), 1, 1e-9);
  const double raised =
      peakPressure(hertz.problem.patches[0], hertz.problem.modulus, {hertz.problem.patches[0].grid, p, 0, 15});
  EXPECT_NEAR(raised / hertz.exact.max_pressure, 1, 5e-4);
  EXPECT_GT(std::abs(p(0, 15) / hertz.exact.max_pressure - 1), 1e-3);
}

/// Two rows of cells next to x = 0, the outer one without pressure, over a gap that is constant in each column.
struct Row
{
  static constexpr double modulus = 1e11;
  PatchGap gap;
  Eigen::ArrayXXd pressure;

  Row(const std::vector<double>& heights, const std::vector<double>& pressures)
  {
    const auto columns = static_cast<int>(heights.size());
    gap.grid = {4, columns, 1e-3, 1e-3, 0, true};
    gap.gap = Eigen::Map<const Eigen::RowVectorXd>(heights.data(), columns).array().replicate(2, 1);
    pressure = Eigen::ArrayXXd::Zero(2, columns);
    pressure.row(0) = Eigen::Map<const Eigen::RowVectorXd>(pressures.data(), columns).array();
  }
  CellsAround cell(int column) const { return {gap.grid, pressure, 0, column}; }
  double at(int column) const { return peakPressure(gap, modulus, cell(column)); }
  bool waves(int column) const { return areWaves(gapSteps(cell(column), gap, modulus)); }
};

TEST(PeakPressure, IsTheCellPressureNextToAnUnloadedCellOrTheBorder)
{
  EXPECT_EQ(Row({0, 0, 0, 0}, {0, 1e9, 8e8, 0}).at(1), 1e9);
  EXPECT_EQ(Row({0, 0, 0, 0}, {1e9, 8e8, 0, 0}).at(0), 1e9);
  EXPECT_EQ(Row({0, 0, 0, 0}, {0, 0, 8e8, 1e9}).at(3), 1e9);
}

TEST(PeakPressure, HasNoBiasCorrectionOnWaves)
{
  std::vector<double> waves, pressures;
  for (int j = 0; j < 24; ++j)
  {
    waves.push_back(1e-6 * std::cos(2 * pi * j / 5.0));
    pressures.push_back(1e9 * (1 - 0.3 * std::cos(2 * pi * j / 5.0)));
  }
  const Row row(waves, pressures);
  Eigen::Index peak = 0;
  row.pressure.row(0).segment(6, 12).maxCoeff(&peak);
  peak += 6;
  const int column = static_cast<int>(peak);
  EXPECT_TRUE(row.waves(column));
  EXPECT_EQ(row.at(column), row.cell(column).parabolas());
  const Row flat(std::vector<double>(24, 0.0), pressures);
  EXPECT_FALSE(flat.waves(column));
  EXPECT_NE(flat.at(column), flat.cell(column).parabolas());
}

/// Peak pressure at the highest cell.
double highest(const PatchGap& gap, double modulus, const Eigen::ArrayXXd& pressure)
{
  Eigen::Index row = 0, column = 0;
  pressure.maxCoeff(&row, &column);
  return peakPressure(gap, modulus, {gap.grid, pressure, row, column});
}

TEST(PeakPressure, IsIndependentOfOrientationAndScale)
{
  const auto askew = [](double x, double y) { return shoulder(x + 2e-4 + 0.05 * y, y - 1e-4); };
  const NormalProblem problem =
      problems::underLoad(problems::sampled(problems::centredGrid(16, 32, 0.018, 0.026, false), askew), 1e5);
  const NormalSolution solution = problems::solved(problem);
  const Eigen::ArrayXXd& pressure = solution.patches[0].pressure;
  PatchGap gap = problem.patches[0];
  const double seen = highest(gap, problem.modulus, pressure);
  EXPECT_NEAR(highest(gap, 1e3 * problem.modulus, 1e3 * pressure) / seen, 1e3, 1e-3);
  gap.gap = problem.patches[0].gap.colwise().reverse();
  EXPECT_NEAR(highest(gap, problem.modulus, pressure.colwise().reverse()) / seen, 1, 1e-6);
  gap.gap = problem.patches[0].gap.rowwise().reverse();
  EXPECT_NEAR(highest(gap, problem.modulus, pressure.rowwise().reverse()) / seen, 1, 1e-6);
}

// The bias is proportional to the bend of the pressure from cell to cell, about an eightieth of it. It decreases with
// the square of the cell size. (Found: 0.0127 to 0.0148 of the bend.)
TEST(PeakPressure, BiasIsProportionalToTheBend)
{
  for (const int cells : {16, 32, 64, 128})
  {
    const auto hertz = problems::hertzCase(2, cells, cells, true);
    const NormalSolution solution = problems::solved(hertz.problem);
    const Eigen::ArrayXXd& pressure = solution.patches[0].pressure;
    Eigen::Index row = 0, column = 0;
    pressure.maxCoeff(&row, &column);
    const CellsAround peak(hertz.problem.patches[0].grid, pressure, row, column);
    const double off = peak.parabolas() / solution.patches[0].max_pressure - 1;
    EXPECT_GT(off, 0.012 * peak.bend()) << cells;
    EXPECT_LT(off, 0.0155 * peak.bend()) << cells;
  }
}

// The pressure may continue beyond the grid: the border is not an edge of the contact.
TEST(PeakPressure, HasNoBiasCorrectionWhereTheBorderCutsThePressure)
{
  const auto hertz = problems::hertzCase(2, 16, 32, false);
  const NormalSolution solution = problems::solved(hertz.problem);
  PatchGap gap = hertz.problem.patches[0];
  const Eigen::ArrayXXd cut = solution.patches[0].pressure.middleRows(4, 12);
  gap.gap = Eigen::ArrayXXd(gap.gap.middleRows(4, 12));
  Eigen::Index row = 0, column = 0;
  cut.maxCoeff(&row, &column);
  const CellsAround peak(gap.grid, cut, row, column);
  ASSERT_TRUE(peak.isCutAlong());
  EXPECT_EQ(peakPressure(gap, hertz.problem.modulus, peak), peak.parabolas());
}

// Next to a much higher peak: the network inputs must be limited.
TEST(PeakPressure, IsCloseToItsCellsNextToAMuchHigherPeak)
{
  const std::vector<double> flat(16, 0.0);
  const Row row(flat, {0, 3e8, 6e8, 1e9, 6e8, 3e40, 6e45, 3e40, 1e8, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_NEAR(row.at(3) / 1e9, 1, 0.1);
}

TEST(PeakPressure, OfAHalfEqualsThatOfTheWhole)
{
  ConjugateGradients solver = problems::solverTo(1e-9);
  const auto peak = [&](bool symmetric)
  {
    const Grid grid = problems::centredGrid(16, 32, 0.018, 0.026, symmetric);
    return problems::solved(solver, problems::underLoad(problems::sampled(grid, shoulder), 1e5))
        .patches[0]
        .max_pressure;
  };
  EXPECT_NEAR(peak(true) / peak(false), 1, 1e-6);
}

/// Bowl whose curvature across jumps by `jump` times its value at y = `discontinuity`.
scenes::Gap discontinuous(double discontinuity, double jump)
{
  return [=](double x, double y)
  {
    const double beyond = std::max(y - discontinuity, 0.0);
    return x * x + 4 * (y * y + jump * beyond * beyond);
  };
}

/// Patch on a grid that covers the pressure of 20 kN on every gap of these tests.
NormalProblem problemOf(const scenes::Gap& gap, const GridSize& size, bool symmetric = false)
{
  return problems::underLoad(
      problems::sampled(problems::centredGrid(size.along, size.across, 13e-3, 7e-3, symmetric), gap), 2e4);
}

PatchPressure solve(const NormalProblem& problem)
{
  ConjugateGradients solver = problems::solverTo(1e-6, 1000);
  const NormalSolution solution = problems::converged(solver, problem);
  EXPECT_FALSE(solution.patches[0].touches_border);
  return solution.patches[0];
}

DiscontinuitySums sumsOf(const NormalProblem& problem, const PatchPressure& patch)
{
  EdgePolygon polygon;
  polygon.frame(patch.pressure, patch.grid.symmetric);
  EXPECT_GT(polygon.cells(patch.grid.dx / patch.grid.dy), 0);
  return sumAtDiscontinuities({polygon, problem.patches[0], problem.modulus, patch.max_pressure});
}

TEST(DiscontinuityBias, SmoothGapsHaveNone)
{
  const NormalProblem problem = problemOf(discontinuous(0, 0), {16, 32});
  const PatchPressure patch = solve(problem);
  EXPECT_EQ(sumsOf(problem, patch).sizes, 0);
  EXPECT_EQ(patch.moved_at_discontinuities, 0);
}

// The ends of the column along the track have no outward side: the lines on both sides are unloaded.
TEST(DiscontinuityBias, BiasOfASingleColumnIsMirrorSymmetric)
{
  NormalProblem problem = problemOf(discontinuous(0.05e-3, 3), {16, 32});
  PatchGap& gap = problem.patches[0];
  PatchPressure patch;
  patch.grid = gap.grid;
  patch.pressure.setZero(gap.gap.rows(), gap.gap.cols());
  patch.pressure.block(4, 15, 8, 1) = 1e9;
  patch.max_pressure = 1e9;
  const DiscontinuitySums sums = sumsOf(problem, patch);
  EXPECT_GT(sums.sizes, 0.01);
  gap.gap = gap.gap.rowwise().reverse().eval();
  patch.pressure = patch.pressure.rowwise().reverse().eval();
  EXPECT_NEAR(sumsOf(problem, patch).bias, sums.bias, 1e-5);
}

TEST(DiscontinuityBias, IsIndependentOfOrientation)
{
  const NormalProblem problem = problemOf(discontinuous(1.6e-3, -1.1), {16, 32});
  const PatchPressure patch = solve(problem);
  const DiscontinuitySums sums = sumsOf(problem, patch);
  EXPECT_GT(sums.sizes, 0.1);
  constexpr double tolerance = 1e-4;  // sums in single precision [cells]
  const auto look = [&](auto turn)
  {
    NormalProblem turned = problem;
    PatchPressure seen = patch;
    turned.patches[0].gap = turn(problem.patches[0].gap);
    seen.pressure = turn(patch.pressure);
    const DiscontinuitySums there = sumsOf(turned, seen);
    EXPECT_NEAR(there.bias, sums.bias, tolerance);
    EXPECT_NEAR(there.sizes, sums.sizes, tolerance);
  };
  look([](const Eigen::ArrayXXd& a) -> Eigen::ArrayXXd { return a.colwise().reverse(); });
  look([](const Eigen::ArrayXXd& a) -> Eigen::ArrayXXd { return a.rowwise().reverse(); });

  const NormalProblem half = problemOf(discontinuous(1.6e-3, -1.1), {16, 32}, true);
  const PatchPressure stored = solve(half);
  EXPECT_NEAR(2 * sumsOf(half, stored).bias, sums.bias, 1e-3);
  EXPECT_NEAR(stored.moved_at_discontinuities / patch.moved_at_discontinuities, 1, 1e-3);
}

/// Mean absolute errors of areas with and without the correction for curvature discontinuities [cells].
class AreaErrors
{
 public:
  void add(const scenes::Gap& gap, const GridSize& size)
  {
    const NormalProblem problem = problemOf(gap, size);
    const PatchPressure coarse = solve(problem), fine = solve(problemOf(gap, {96, 192}));
    const double error = (coarse.area - fine.area) / coarse.grid.cellArea();
    with_ += std::abs(error);
    without_ += std::abs(error + sumsOf(problem, coarse).bias);
    ++count_;
  }
  double with() const { return with_ / count_; }
  double without() const { return without_ / count_; }
  void print(const char* gaps) const
  {
    std::cout << count_ << ' ' << gaps << ": mean area error " << with() << " cells, " << without()
              << " cells without the correction\n";
  }

 private:
  double with_ = 0, without_ = 0;
  int count_ = 0;
};

// Discontinuities from well inside the edge to beyond it, with jumps to higher and lower curvature.
TEST(DiscontinuityBias, CorrectedAreaIsCloserToThatOfFineCells)
{
  AreaErrors errors;
  for (const double jump : {-0.9, -0.5, 1.0, 3.0})
  {
    for (double discontinuity = 0.8e-3; discontinuity < 2.5e-3; discontinuity += 0.15e-3)
    {
      errors.add(discontinuous(discontinuity, jump), {12, 24});
    }
  }
  errors.print("curvature discontinuities");
  EXPECT_LT(errors.with(), 0.6 * errors.without());
}

// A curvature that increases smoothly has steps as well.
TEST(DiscontinuityBias, CorrectedAreaIsCloserAlsoForSmoothlyIncreasingCurvature)
{
  AreaErrors errors;
  for (const GridSize& size : {GridSize{8, 16}, GridSize{12, 24}})
  {
    for (double fourth = 1e5; fourth < 1.5e6; fourth *= 1.3)
    {
      errors.add([=](double x, double y) { return x * x + (1 + fourth * y * y) * y * y; }, size);
    }
  }
  errors.print("smooth gaps");
  EXPECT_LT(errors.with(), 0.6 * errors.without());
}
}  // namespace
