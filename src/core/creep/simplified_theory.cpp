// SPDX-License-Identifier: BSD-3-Clause
#include "core/creep/simplified_theory.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Steps along a strip of FASTSIM, and the top of its parabolic bound over the mean bound at their centres.
constexpr int strip_steps = 30;
constexpr double peak_over_mean = 1.5 / (1 + 0.5 / (strip_steps * strip_steps));
/// Linear force over the friction limit from which the patch slides (Vermeulen and Johnson 1964).
constexpr double sliding_demand = 3;

// Largest errors of the forces over mu N, on 190 ellipses of CONTACT and 115 of the chart in doc/methods.md (the larger
// ones at a/b = 0.2): without spin, and what spin adds per reduced spin, with FASTSIM up to a reduced spin of a half.
constexpr double fastsim_error = 0.1, fastsim_spin_error = 0.2;
constexpr double linear_error = 0.1, linear_spin_error = 0.5;

/// Semi-ellipse of pressure along a column.
struct PressureStrip
{
  double force = 0;   ///< sum of the pressures of the cells [Pa]
  double centre = 0;  ///< x of its centre [m]
  double half = 0;    ///< half its length [m]
};

PressureStrip stripOf(const CreepProblem& problem, int column)
{
  const PatchGrid& grid = problem.grid;
  double sum = 0, first = 0, second = 0;
  for (int i = 0; i < grid.nx; ++i)
  {
    const double p = problem.pressure(i, column);
    sum += p;
    first += p * i;
    second += p * i * i;
  }
  if (!(sum > 0))
  {
    return {};
  }
  const double mean = first / sum;
  // The variance of a semi-ellipse is a quarter of its half length squared; a single cell has that of a uniform load.
  const double variance = std::max(second / sum - mean * mean, 1.0 / 12);
  return {sum, grid.x0 + mean * grid.dx, 2 * std::sqrt(variance) * grid.dx};
}

/// Sums over a patch, of tractions in axes whose x is the direction of travel.
struct TractionSums
{
  double x = 0, y = 0, moment = 0;
};

/// Growth of the traction per length on the way through the patch, times -1: (x - y_spin * y, y + y_spin * x) at (x,
/// y).
struct Growth
{
  double x = 0, y = 0, spin = 0;
};

/// Adds the tractions of a strip at y. `x` is its centre. `peak` is the top of its bound [Pa].
void addStrip(const Growth& growth, double x, double y, double half, double peak, TractionSums& sums)
{
  const double step = 2 * half / strip_steps, rate_x = growth.x - growth.spin * y;
  double px = 0, py = 0, sum_x = 0, sum_y = 0, moment = 0;
  for (int i = 0; i < strip_steps; ++i)
  {
    const double u = 1 - (2 * i + 1.0) / strip_steps;  // from the centre, over the half length
    const double way = i == 0 ? 0.5 * step : step;
    px -= rate_x * way;
    py -= (growth.y + growth.spin * (x + half * u + 0.5 * way)) * way;
    const double bound = peak * (1 - u * u), square = px * px + py * py;
    if (square > bound * bound)
    {
      const double scale = bound / std::sqrt(square);
      px *= scale;
      py *= scale;
    }
    sum_x += px;
    sum_y += py;
    moment += (x + half * u) * py;
  }
  sums.x += sum_x * step;
  sums.y += sum_y * step;
  sums.moment += (moment - y * sum_x) * step;
}
}  // namespace

bool hasPressure(const CreepProblem& problem)
{
  const PatchGrid& grid = problem.grid;
  const Eigen::ArrayXXd& p = problem.pressure;
  const double origin = grid.x0 + grid.y0;
  if (grid.nx < 1 || grid.ny < 1 || p.rows() != grid.nx || p.cols() != grid.ny || !std::isfinite(origin))
  {
    return false;
  }
  const double sum = p.sum() * grid.dx * grid.dy;
  return grid.dx > 0 && grid.dy > 0 && sum > 0 && std::isfinite(sum) && (p >= 0).all();
}

Flexibility flexibility(const CreepProblem& problem)
{
  const double a = problem.semi_axis_along, ratio = a / problem.semi_axis_across;
  const KalkerCoefficients c = kalkerCoefficients(ratio, problem.elasticity.poisson);
  const double over_modulus = a / problem.elasticity.modulus;
  return {8 * over_modulus / (3 * c.c11), 8 * over_modulus / (3 * c.c22),
          pi * over_modulus * std::sqrt(ratio) / (4 * c.c23)};
}

double reducedSpin(const CreepProblem& problem, double friction)
{
  const double product = problem.semi_axis_along * problem.semi_axis_across;
  return 1.5 * product * std::sqrt(product) * problem.elasticity.modulus * std::abs(problem.creepage.spin) /
         (friction * problem.normal_force);
}

CreepStatus LinearLaw::fill(const CreepProblem& problem, bool /*warm*/, CreepSolution& solution)
{
  const double a = problem.semi_axis_along, b = problem.semi_axis_across;
  const KalkerCoefficients c = kalkerCoefficients(a / b, problem.elasticity.poisson);
  const double square = a * b * problem.elasticity.modulus, length = std::sqrt(a * b);
  const double cross = directionOf(problem) * square * length * c.c23;
  const Creepage& creep = problem.creepage;
  const CreepForce linear = {-square * c.c11 * creep.x, -square * c.c22 * creep.y - cross * creep.spin,
                             cross * creep.y - square * a * b * c.c33 * creep.spin};
  const double limit = solution.friction * problem.normal_force, resultant = std::hypot(linear.x, linear.y);
  const double e = resultant / limit;
  // As a function of e, the factor is continuous at 0 and at the limit.
  const double scale = e < sliding_demand ? 1 - e / 3 + e * e / 27 : 1 / e;
  solution.force = {scale * linear.x, scale * linear.y, scale * linear.moment};
  solution.error_estimate = std::min(1.0, linear_error + linear_spin_error * reducedSpin(problem, solution.friction));
  solution.iterations = 0;
  return CreepStatus::converged;
}

CreepStatus Fastsim::fill(const CreepProblem& problem, bool /*warm*/, CreepSolution& solution)
{
  if (!hasPressure(problem))
  {
    return CreepStatus::invalid_problem;
  }
  const PatchGrid& grid = problem.grid;
  const Flexibility flex = flexibility(problem);
  const double direction = directionOf(problem);
  const Growth growth = {direction * problem.creepage.x / flex.x, direction * problem.creepage.y / flex.y,
                         problem.creepage.spin / flex.spin};
  const double limit = solution.friction * problem.normal_force;
  const double scale = limit / (problem.pressure.sum() * grid.cellArea());
  TractionSums sums;
  for (int j = 0; j < grid.ny; ++j)
  {
    const PressureStrip strip = stripOf(problem, j);
    if (strip.force > 0)
    {
      const double peak = peak_over_mean * scale * strip.force * grid.dx / (2 * strip.half);
      addStrip(growth, direction * strip.centre, direction * grid.y(j), strip.half, peak, sums);
    }
  }
  solution.force = {direction * sums.x * grid.dy, direction * sums.y * grid.dy, sums.moment * grid.dy};
  solution.error_estimate = fastsim_error + fastsim_spin_error * std::min(0.5, reducedSpin(problem, solution.friction));
  solution.iterations = 1;
  return CreepStatus::converged;
}
}  // namespace wheel_rail_contact::core
