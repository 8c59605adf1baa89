// SPDX-License-Identifier: BSD-3-Clause
#include "core/creep/simplified_theory.h"

#include <algorithm>
#include <cmath>

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

/// Growth of the traction per length on the way through a strip, times -1: (x, y + spin * x) at x. The axes are those
/// of a wheel that rolls forward. The lateral creepage is that at the centre of pressure, about which the wheel spins:
/// nothing depends on the place of the grid.
struct Growth
{
  double x = 0, y = 0, spin = 0;
};

Growth growthOf(const CreepProblem& problem, int column, const CreepStrip& strip)
{
  const double direction = directionOf(problem);
  const Creepage creep = creepageOf(problem, column);
  const Flexibility& flex = strip.flexibility;
  const double lateral = creep.y + creep.spin * strip.middle, spin = creep.spin / flex.spin;
  return {direction * (strip.creepage_x / flex.x + (creep.x - strip.creepage_x) / flex.spin),
          direction * (lateral / flex.y - strip.middle * spin), spin};
}

/// Tractions of a strip, summed along it [N/m], and their moment about z at x = 0 [N]. `x` is the centre of the strip,
/// `peak` the top of its bound [Pa].
CreepForce forceOf(const Growth& growth, double x, double half, double peak)
{
  const double step = 2 * half / strip_steps;
  double px = 0, py = 0, sum_x = 0, sum_y = 0, moment = 0;
  for (int i = 0; i < strip_steps; ++i)
  {
    const double u = 1 - (2 * i + 1.0) / strip_steps;  // from the centre, over the half length
    const double way = i == 0 ? 0.5 * step : step;
    px -= growth.x * way;
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
  return {sum_x * step, sum_y * step, moment * step};
}
}  // namespace

bool hasPressure(const CreepProblem& problem)
{
  const PatchGrid& grid = problem.grid;
  const Eigen::ArrayXXd& p = problem.pressure;
  const double origin = grid.x0 + grid.y0;
  if (grid.nx < 1 || grid.ny < 1 || p.rows() != grid.nx || p.cols() != grid.ny || !std::isfinite(origin) ||
      (!problem.columns.empty() && problem.columns.size() != static_cast<std::size_t>(grid.ny)))
  {
    return false;
  }
  const double sum = p.sum() * grid.dx * grid.dy;
  return grid.dx > 0 && grid.dy > 0 && sum > 0 && std::isfinite(sum) && (p >= 0).all();
}

double reducedSpin(const CreepProblem& problem, double spin)
{
  const double product = problem.semi_axis_along * problem.semi_axis_across;
  return 1.5 * product * std::sqrt(product) * problem.elasticity.modulus * std::abs(spin) / problem.normal_force;
}

CreepStatus LinearLaw::fill(const CreepProblem& problem, bool /*warm*/, CreepSolution& solution)
{
  const double a = problem.semi_axis_along, b = problem.semi_axis_across;
  if (!(a > 0 && b > 0 && std::isfinite(a) && std::isfinite(b)))
  {
    return CreepStatus::invalid_problem;
  }
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
  solution.error_estimate =
      std::min(1.0, linear_error + linear_spin_error * reducedSpin(problem, creep.spin / solution.friction));
  solution.iterations = 0;
  return CreepStatus::converged;
}

CreepStatus Fastsim::fill(const CreepProblem& problem, bool /*warm*/, CreepSolution& solution)
{
  if (!isAgain() && !hasPressure(problem))
  {
    return CreepStatus::invalid_problem;
  }
  const double direction = directionOf(problem), width = problem.grid.dy;
  const std::vector<CreepStrip>& strips = isAgain() ? strips_.roll(problem) : strips_.find(problem);
  solution.columns.assign(strips.size(), {});
  solution.limits.assign(strips.size(), 0);
  double spin = 0, limits = 0;  // sums, of the spin times the load
  for (int j = 0; j < problem.grid.ny; ++j)
  {
    const CreepStrip& strip = strips[static_cast<std::size_t>(j)];
    if (strip.force > 0)
    {
      const double limit = frictionOf(problem, j) * strip.force;
      const double peak = peak_over_mean * limit / (2 * strip.half * width);
      const CreepForce force = forceOf(growthOf(problem, j, strip), direction * strip.centre, strip.half, peak);
      solution.columns[static_cast<std::size_t>(j)] = {direction * width * force.x, direction * width * force.y,
                                                       width * force.moment};
      solution.limits[static_cast<std::size_t>(j)] = limit;
      spin += strip.force * std::abs(creepageOf(problem, j).spin);
      limits += limit;
    }
  }
  solution.error_estimate = fastsim_error + fastsim_spin_error * std::min(0.5, reducedSpin(problem, spin / limits));
  solution.iterations = 1;
  return CreepStatus::converged;
}
}  // namespace wheel_rail_contact::core
