// SPDX-License-Identifier: BSD-3-Clause
#include "core/creep/simplified_theory.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/simd/wide.h"

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

/// Strips that are solved side by side, in axes of a wheel that rolls forward.
struct StripGroup
{
  static constexpr std::size_t together = 8;
  using Each = std::array<double, together>;

  std::array<std::size_t, together> column{};
  /// Growth of the traction per length on the way through a strip, times -1: (growth_x, growth_y + spin * x) at x. The
  /// lateral creepage is that at the centre of pressure, about which the wheel spins: nothing depends on the place of
  /// the grid.
  Each growth_x{}, growth_y{}, spin{};
  Each centre{}, half{}, peak{};    ///< x of the centre [m], half the length [m], top of the bound [Pa]
  Each sum_x{}, sum_y{}, moment{};  ///< of the tractions in the steps [Pa], and about z at x = 0 [N/m]

  void set(std::size_t k, const CreepProblem& problem, int at, const CreepStrip& strip, double limit)
  {
    const double direction = directionOf(problem);
    const Creepage creep = creepageOf(problem, at);
    const Flexibility& flex = strip.flexibility;
    column[k] = static_cast<std::size_t>(at);
    spin[k] = creep.spin / flex.spin;
    growth_x[k] = direction * (strip.creepage_x / flex.x + (creep.x - strip.creepage_x) / flex.spin);
    growth_y[k] = direction * ((creep.y + creep.spin * strip.middle) / flex.y - strip.middle * spin[k]);
    centre[k] = direction * strip.centre;
    half[k] = strip.half;
    peak[k] = peak_over_mean * limit / (2 * strip.half * problem.grid.dy);
  }
};

WHEEL_RAIL_CONTACT_WIDE void solveStrips(StripGroup& strips)
{
  StripGroup::Each px{}, py{};
  strips.sum_x = strips.sum_y = strips.moment = {};
  for (int i = 0; i < strip_steps; ++i)
  {
    const double u = 1 - (2 * i + 1.0) / strip_steps, share = (i == 0 ? 1.0 : 2.0) / strip_steps;  // of the half length
    for (std::size_t k = 0; k < StripGroup::together; ++k)
    {
      const double way = share * strips.half[k], x = strips.centre[k] + u * strips.half[k];
      px[k] -= strips.growth_x[k] * way;
      py[k] -= (strips.growth_y[k] + strips.spin[k] * (x + 0.5 * way)) * way;
      const double bound = strips.peak[k] * (1 - u * u), square = px[k] * px[k] + py[k] * py[k];
      const double scale = square > bound * bound ? bound / std::sqrt(square) : 1;
      px[k] *= scale;
      py[k] *= scale;
      strips.sum_x[k] += px[k];
      strips.sum_y[k] += py[k];
      strips.moment[k] += x * py[k];
    }
  }
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
  StripGroup group;
  std::size_t count = 0;
  for (int j = 0; j < problem.grid.ny; ++j)
  {
    const CreepStrip& strip = strips[static_cast<std::size_t>(j)];
    if (strip.force > 0)
    {
      const double limit = frictionOf(problem, j) * strip.force;
      group.set(count++, problem, j, strip, limit);
      solution.limits[static_cast<std::size_t>(j)] = limit;
      spin += strip.force * std::abs(creepageOf(problem, j).spin);
      limits += limit;
    }
    if (count == StripGroup::together || j + 1 == problem.grid.ny)
    {
      solveStrips(group);
      while (count > 0)
      {
        const std::size_t k = --count;
        const double area = 2 * group.half[k] / strip_steps * width;  // of a step
        solution.columns[group.column[k]] = {direction * area * group.sum_x[k], direction * area * group.sum_y[k],
                                             area * group.moment[k]};
      }
    }
  }
  solution.error_estimate = fastsim_error + fastsim_spin_error * std::min(0.5, reducedSpin(problem, spin / limits));
  solution.iterations = 1;
  return CreepStatus::converged;
}
}  // namespace wheel_rail_contact::core
