// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/kik_piotrowski.h"

#include "core/constants.h"
#include "core/normal/solvers/hertz_solver.h"
#include "core/normal/solvers/patch_fields.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double load_tolerance = 1e-10;  ///< relative error of the load
constexpr int most_evaluations = 60;

/// Output of test/calibration/calibrate_error_estimate.cpp in revision 46df9a4.
constexpr ShapeWeights strip_error_weights{
    {0.113, 0, 0.847, 0.00813}, {0.100, 0.0661, 0.0013, 0.0112}, {0.0622, 0, 0.0560, 0.00569}};

/// Paraboloid, with axes along x and y, whose part below `level` has the centroid and second moments of the volume of
/// the gap below it. Requires at least one cell below the level.
GapMinimum momentParaboloid(const PatchGap& gap, double level)
{
  const Grid& grid = gap.grid;
  double sum = 0, x1 = 0, x2 = 0, y1 = 0, y2 = 0, deepest = 0;
  for (int j = 0; j < grid.ny; ++j)
  {
    double column = 0;
    for (int i = 0; i < grid.rows(); ++i)
    {
      const double depth = std::max(level - gap.gap(i, j), 0.0), x = grid.x(i);
      column += depth;
      deepest = std::max(deepest, depth);
      x1 += depth * x;
      x2 += depth * x * x;
    }
    const double y = grid.y(j);
    sum += column;
    y1 += column * y;
    y2 += column * y * y;
  }
  GapMinimum paraboloid;
  paraboloid.gap = level - deepest;
  paraboloid.x = grid.symmetric ? 0 : x1 / sum;
  paraboloid.y = y1 / sum;
  // The second moment of a paraboloid about its axis is a sixth of the squared semi-axis. That of a cell about its own
  // axis is added.
  const double half_x2 = 6 * (x2 / sum - paraboloid.x * paraboloid.x + grid.dx * grid.dx / 12);
  const double half_y2 = 6 * (y2 / sum - paraboloid.y * paraboloid.y + grid.dy * grid.dy / 12);
  paraboloid.curvature = {deepest / half_x2, deepest / half_y2};
  return paraboloid;
}
}  // namespace

bool KikPiotrowski::fit(const NormalProblem& problem)
{
  gaps_.resize(problem.patches.size());
  areas_.resize(problem.patches.size());
  bool large_enough = true;
  for (std::size_t k = 0; k < gaps_.size(); ++k)
  {
    large_enough = large_enough && fitStrips(problem.patches[k], gaps_[k]);
  }
  return large_enough;
}

/// Load at a common approach. Returns false if the gap of a loaded strip does not open along x.
bool KikPiotrowski::loadAt(const NormalProblem& problem, double approach, double& load)
{
  load = 0;
  for (std::size_t k = 0; k < gaps_.size(); ++k)
  {
    const PatchGap& patch = problem.patches[k];
    areas_[k] = stripAreaAt(gaps_[k], problem.modulus, patch.weight * approach - gaps_[k].deepest.gap);
    load += patch.weight * areas_[k].force;
    if (!areas_[k].sound)
    {
      return false;
    }
  }
  return true;
}

double KikPiotrowski::firstTouch(const NormalProblem& problem) const
{
  double first = infinity;
  for (std::size_t k = 0; k < gaps_.size(); ++k)
  {
    first = std::min(first, gaps_[k].deepest.gap / problem.patches[k].weight);
  }
  return first;
}

/// Common approach that carries the load, by a secant method on the logarithms of approach (from the first touch) and
/// load. A Hertz load is proportional to the power 3/2 of the approach.
SolveStatus KikPiotrowski::findApproach(const NormalProblem& problem, NormalSolution& solution)
{
  const double first = firstTouch(problem), bend = gaps_[0].deepest.bend;
  if (!(bend > 0))
  {
    return SolveStatus::no_positive_curvature;
  }
  // First value: a sphere with the curvature along x (Johnson 1985, eq. 4.23).
  const double pressed = problem.value / problem.modulus;
  double log_approach = std::log(9.0 / 8.0 * pressed * pressed * bend) / 3;
  double power = 1.5, last_approach = 0, last_error = 0;
  for (solution.iterations = 1; solution.iterations <= most_evaluations; ++solution.iterations)
  {
    solution.approach = first + std::exp(log_approach);
    double load = 0;
    if (!loadAt(problem, solution.approach, load))
    {
      return SolveStatus::no_positive_curvature;
    }
    solution.residual = std::abs(load / problem.value - 1);
    if (solution.residual < load_tolerance)
    {
      return SolveStatus::converged;
    }
    const double error = std::log(load / problem.value);
    if (solution.iterations > 1 && log_approach != last_approach)
    {
      power = std::clamp((error - last_error) / (log_approach - last_approach), 0.8, 4.0);
    }
    last_approach = log_approach;
    last_error = error;
    log_approach -= error / power;
  }
  return SolveStatus::iteration_limit;
}

SolveStatus KikPiotrowski::findAreas(const NormalProblem& problem, NormalSolution& solution)
{
  if (!isValid(problem) || !fit(problem))
  {
    return SolveStatus::invalid_problem;
  }
  if (problem.control == NormalProblem::Control::load)
  {
    return findApproach(problem, solution);
  }
  double load = 0;
  solution.approach = problem.value;
  solution.iterations = 1;
  const bool sound = loadAt(problem, problem.value, load);
  return !sound ? SolveStatus::no_positive_curvature : load > 0 ? SolveStatus::converged : SolveStatus::no_contact;
}

void KikPiotrowski::solve(const NormalProblem& problem, bool /*warm*/, NormalSolution& solution)
{
  solution.patches.resize(problem.patches.size());
  solution.iterations = 0;
  solution.residual = 0;
  solution.status = findAreas(problem, solution);
  for (std::size_t k = 0; isUsable(solution.status) && k < problem.patches.size(); ++k)
  {
    const Grid& grid = problem.patches[k].grid;
    const StripArea& area = areas_[k];
    PatchPressure& patch = solution.patches[k];
    patch.grid = grid;
    fillPressure(grid, gaps_[k], area, patch.pressure);
    patch.force = area.force;
    patch.area = area.area;
    patch.moved_at_discontinuities = 0;
    measures_.measureRatio(patch);
    patch.max_pressure = std::max(area.pressure, patch.pressure.maxCoeff());
    const Eigen::ArrayXXd& p = patch.pressure;
    const bool ends = p.row(p.rows() - 1).maxCoeff() > 0 || (!grid.symmetric && p.row(0).maxCoeff() > 0);
    patch.touches_border = ends || p.col(0).maxCoeff() > 0 || p.col(p.cols() - 1).maxCoeff() > 0;
  }
}

ShapeTerms KikPiotrowski::errorTerms(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch)
{
  const double own = ownApproach(problem, solution, patch);
  const PatchGap& gap = problem.patches[patch];
  const double level = gap.weight * solution.approach - own + 0.5 * own;
  const GapMinimum paraboloid = momentParaboloid(gap, level);
  const OverlapMismatch mismatch = compareOverlap(gap, paraboloid, level);
  const double aspect = std::log(paraboloid.curvature.a / paraboloid.curvature.b);
  return {1, mismatch.volume, mismatch.shape, aspect * aspect};
}

void KikPiotrowski::estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                                   std::vector<ErrorEstimate>& errors) const
{
  const auto alone = [&](std::size_t k)
  {
    if (!(solution.patches[k].force > 0))
    {
      return ErrorEstimate();
    }
    // If the bodies overlap only between the cells, the cells give no error terms.
    const bool known = ownApproach(problem, solution, k) > 0;
    return known ? weighted(strip_error_weights, errorTerms(problem, solution, k)) : ErrorEstimate{1, 1, 1};
  };
  withSharedApproach(problem, solution, alone, errors);
}
}  // namespace wheel_rail_contact::core
