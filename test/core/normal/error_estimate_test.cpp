// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/estimate/error_estimate.h"

#include "error_samples.h"

namespace wheel_rail_contact::core
{
namespace
{
using scenes::ErrorSample;

constexpr std::size_t used_grids = 10;  ///< number of grids used: the coarsest of scenes::grids, up to 16 × 64 cells

/// Samples of new random scenes: half wheelsets (whole calculation), half gaps; for the slow iterations only gaps. The
/// calibration used the seeds 1, 2 and 11.
std::vector<ErrorSample> freshSamples(NormalMethod method, int count, unsigned long seed)
{
  std::cout << "seed " << seed << ", " << count << " scenes\n";
  scenes::Random seeds(seed);
  scenes::GapSampler gaps;
  scenes::WheelsetSampler wheelsets(method);
  const bool only_gaps = scenes::isSeidel(method);
  std::vector<ErrorSample> samples;
  for (int i = 0; i < count; ++i)
  {
    scenes::Random random(seeds());
    const GridSize& size = scenes::grids[random() % used_grids];
    only_gaps || i % 2 > 0 ? gaps.sample(method, scenes::randomGapScene(method, random), size, random, samples)
                           : wheelsets.sample(scenes::randomWheelsetScene(random), size, samples);
  }
  return samples;
}

/// Two requirements on an estimate: it is at least the true error in 95 of 100 cases, and its median ratio to the true
/// error is at most four. The true error is that against the same scene on a grid four times finer in each direction.
void expectCalibrated(const std::vector<ErrorSample>& samples)
{
  ASSERT_GT(samples.size(), 100U);
  int held = 0;
  std::vector<double> ratios;
  for (const ErrorSample& sample : samples)
  {
    held += sample.error.largest() <= sample.estimate.largest() ? 1 : 0;
    ratios.push_back(sample.estimate.largest() / sample.error.largest());
  }
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
  const double share = static_cast<double>(held) / static_cast<double>(samples.size());
  const double median = ratios[ratios.size() / 2];
  std::cout << samples.size() << " patches: true error within the estimate in " << 100 * share
            << " %, median of estimate over true error " << median << "\n";
  EXPECT_GE(share, 0.95);
  EXPECT_LE(median, 4);
}

// The point forces of `seidel_printed` cause larger errors than the grid. About a third of its scenes is rejected
// because of long cells.
TEST(ErrorEstimate, HoldsOnNewScenesOfEachMethod)
{
  const std::tuple<NormalMethod, int, unsigned long> methods[] = {{NormalMethod::conjugate_gradient, 260, 211},
                                                                  {NormalMethod::hertz, 180, 12},
                                                                  {NormalMethod::kik_piotrowski, 180, 13},
                                                                  {NormalMethod::seidel, 480, 14},
                                                                  {NormalMethod::seidel_printed, 240, 16}};
  for (const auto& [method, count, seed] : methods)
  {
    SCOPED_TRACE(toString(method));
    expectCalibrated(freshSamples(method, count, seed));
  }
}

NormalProblem paraboloid(const GridSize& size, double along, double across)
{
  constexpr double load = 5e4;
  const HertzContact contact = hertzForForce({along, across}, problems::steel(), load);
  const cell_aspect::Cell cell =
      cell_aspect::coveringCell(2.2 * contact.semi_axis_x, 2.2 * contact.semi_axis_y, size.along, size.across);
  const Grid grid{size.along, size.across, cell.dx, cell.dy, -0.5 * (size.across - 1) * cell.dy, true};
  return problems::underLoad(
      problems::sampled(grid, [=](double x, double y) { return along * x * x + across * y * y; }), load);
}

TEST(ErrorEstimate, DecreasesWithTheCellSize)
{
  ConjugateGradients solver;
  double before = 1;
  for (const GridSize& size : {GridSize{4, 16}, GridSize{8, 24}, GridSize{16, 48}, GridSize{32, 96}})
  {
    const NormalProblem problem = paraboloid(size, 1.1, 2.0);
    const NormalSolution solution = problems::converged(solver, problem);
    const double estimate = errorsOf(solver, problem, solution)[0].largest();
    EXPECT_GT(estimate, 0);
    EXPECT_LT(estimate, 0.6 * before);
    before = estimate;
  }
}

TEST(ErrorEstimate, IsTheSameWithAndWithoutSymmetry)
{
  NormalProblem half = paraboloid({16, 32}, 1.1, 2.0), whole = half;
  Grid grid = half.patches[0].grid;
  grid.symmetric = false;
  whole.patches[0] = problems::sampled(grid, [](double x, double y) { return 1.1 * x * x + 2.0 * y * y; });
  ConjugateGradients solver = problems::solverTo(1e-9);
  const ErrorEstimate a = errorsOf(solver, half, problems::solved(solver, half))[0],
                      b = errorsOf(solver, whole, problems::solved(solver, whole))[0];
  EXPECT_NEAR(a.max_pressure, b.max_pressure, 1e-4 * a.max_pressure);
  EXPECT_NEAR(a.area, b.area, 1e-4 * a.area);
  EXPECT_NEAR(a.approach, b.approach, 1e-4 * a.approach);
}

/// True relative error of the highest pressure on a grid, against cells four times finer in each direction, and its
/// estimate.
struct PeakError
{
  double truth = 0, estimate = 0;
};

PeakError peakError(NormalProblem problem, const scenes::Gap& gap)
{
  ConjugateGradients solver;
  problem.patches[0] = problems::sampled(problem.patches[0].grid, gap);
  const NormalSolution coarse = problems::solved(solver, problem);
  const double estimate = errorsOf(solver, problem, coarse)[0].max_pressure;
  problem.patches[0] = problems::sampled(scenes::refined(problem.patches[0].grid, scenes::finer), gap);
  const NormalSolution fine = problems::solved(solver, problem);
  EXPECT_EQ(coarse.status, SolveStatus::converged);
  EXPECT_EQ(fine.status, SolveStatus::converged);
  return {std::abs(coarse.patches[0].max_pressure / fine.patches[0].max_pressure - 1), estimate};
}

// A wheel of 0.46 m radius on a crown that joins a shoulder, at several positions among the cells. At one of five
// positions the error may exceed the estimate, by at most a quarter.
TEST(ErrorEstimate, HoldsAtACurvatureJumpUnderThePeak)
{
  for (const GridSize& size : {GridSize{8, 16}, GridSize{12, 32}, GridSize{16, 48}, GridSize{24, 56}})
  {
    const Grid grid = problems::centredGrid(size.along, size.across, 0.018, 0.026, true);
    const NormalProblem problem = problems::underLoad({grid, {}, {}}, 1e5);
    int held = 0;
    for (const double shift : {0.0, 0.2, 0.4, 0.6, 0.8})
    {
      const double discontinuity = shift * grid.dy;
      const PeakError error = peakError(
          problem, [discontinuity](double x, double y)
          { return x * x / 0.92 + (y - discontinuity) * (y - discontinuity) / (y > discontinuity ? 0.1 : 0.8); });
      std::cout << size.along << " x " << size.across << ": true " << error.truth << ", estimated " << error.estimate
                << "\n";
      held += error.truth <= error.estimate ? 1 : 0;
      EXPECT_LE(error.truth, 1.25 * error.estimate);
      EXPECT_LT(error.estimate, 0.3);
    }
    EXPECT_GE(held, 4);
  }
}

/// Patches of S1002 on a rail at the lateral displacement y [m] under a wheel load [N], with the true errors of their
/// highest pressure.
std::vector<ErrorSample> patchesOf(Profile (*rail)(), double y, double wheel_load, const GridSize& size)
{
  scenes::WheelsetScene scene;
  scene.config.wheel_profile = std::make_shared<Profile>(s1002Wheel());
  scene.config.rail_profile = std::make_shared<Profile>(rail());
  scene.state.y = y;
  scene.state.force_z = -2 * wheel_load;
  std::vector<ErrorSample> samples;
  EXPECT_TRUE(scenes::WheelsetSampler(NormalMethod::conjugate_gradient).sample(scene, size, samples));
  return samples;
}

// The highest cell is in the wider of two lobes. The true maximum is in the narrower one, where the rail radii of 300
// mm and 80 mm meet.
TEST(ErrorEstimate, IncludesSecondaryPeaksThatGrowOnFinerCells)
{
  double largest = 0;
  for (const ErrorSample& sample : patchesOf(rail60E1, 0.000035, 40000, {8, 16}))
  {
    std::cout << "true " << sample.error.max_pressure << ", estimated " << sample.estimate.max_pressure << "\n";
    EXPECT_LE(sample.error.max_pressure, sample.estimate.max_pressure);
    largest = std::max(largest, sample.error.max_pressure);
  }
  EXPECT_GT(largest, 0.03);
}

// The pressure at a step of the gap has no maximum. On a grid it grows as the cells shrink.
TEST(ErrorEstimate, IncludesTheSpikeAtAStep)
{
  for (const double place : {0.45, 0.55, 0.65, 0.75})
  {
    const NormalProblem smooth = paraboloid({24, 56}, 1.1, 60);
    const Grid& grid = smooth.patches[0].grid;
    const double step = 6e-7, at = (place / 1.1 * 0.5) * grid.ny * grid.dy;
    const auto gap = [=](double x, double y) { return 1.1 * x * x + 60 * y * y - (y > at ? step : 0); };
    const PeakError error = peakError(smooth, gap);
    std::cout << "place " << place << ", true " << error.truth << ", estimated " << error.estimate << "\n";
    EXPECT_GE(error.estimate, error.truth);
    EXPECT_GT(error.truth, 0.3);
  }
}

// Under a light load at y = 0.6 mm, where the curvature of the rail jumps, the pressure has a narrow end: 3 mm across
// the track, and down to a tenth of a millimetre along it. On the grid it is two cells long everywhere.
TEST(ErrorEstimate, IncludesEndsNarrowerThanTheCells)
{
  for (const GridSize& size : {GridSize{10, 24}, GridSize{16, 48}, GridSize{24, 96}})
  {
    const std::vector<ErrorSample> samples = patchesOf(railUic60Manchester, 0.000634, 6100, size);
    for (const ErrorSample& sample : samples)
    {
      std::cout << "true " << sample.error.area << ", estimated " << sample.estimate.area << "\n";
    }
    // Only the left wheel touches at the narrow end.
    const ErrorSample& narrow = samples.at(0);
    EXPECT_LE(narrow.error.area, narrow.estimate.area);
    EXPECT_GT(narrow.error.area, 0.004);
    const double of_narrow_ends = std::max(gridErrorWeights().area[1] * narrow.terms.area[1], narrow.terms.narrow_end);
    EXPECT_GT(of_narrow_ends, 0.5 * narrow.estimate.area);
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
