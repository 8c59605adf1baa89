// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/constants.h"
#include "core/option_check.h"
#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Length and width of the grid over those of the ellipse.
constexpr double grid_margin = 1.05;
constexpr int most_cells = 1024;
}  // namespace

CreepProblem ellipseProblem(const CreepEllipse& ellipse, const Creepage& creepage)
{
  const double a = ellipse.semi_axis_along, b = ellipse.semi_axis_across;
  requirePositive("semi_axis_along", a);
  requirePositive("semi_axis_across", b);
  requirePositive("normal_force", ellipse.normal_force);
  require(ellipse.nx >= 1 && ellipse.nx <= most_cells, "nx", ellipse.nx, "must be from 1 to 1024");
  require(ellipse.ny >= 1 && ellipse.ny <= most_cells, "ny", ellipse.ny, "must be from 1 to 1024");
  CreepProblem problem;
  problem.creepage = creepage;
  problem.normal_force = ellipse.normal_force;
  problem.semi_axis_along = a;
  problem.semi_axis_across = b;
  PatchGrid& grid = problem.grid;
  grid.nx = ellipse.nx;
  grid.ny = ellipse.ny;
  grid.dx = 2 * grid_margin * a / grid.nx;
  grid.dy = 2 * grid_margin * b / grid.ny;
  grid.x0 = 0.5 * (1 - grid.nx) * grid.dx;
  grid.y0 = 0.5 * (1 - grid.ny) * grid.dy;
  problem.pressure.resize(grid.nx, grid.ny);
  const double peak = 1.5 * ellipse.normal_force / (pi * a * b);
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.nx; ++i)
    {
      const double u = grid.x(i) / a, v = grid.y(j) / b;
      problem.pressure(i, j) = peak * std::sqrt(std::max(0.0, 1 - u * u - v * v));
    }
  }
  return problem;
}

CreepForce ellipseCreepForce(const CreepEllipse& ellipse, const Creepage& creepage, CreepMethod method,
                             const FrictionLaw& friction, const ShearElasticity& elasticity)
{
  validate(friction, "");
  requirePositive("shear modulus", elasticity.modulus);
  require(elasticity.poisson >= 0 && elasticity.poisson <= 0.5, "poisson", elasticity.poisson, "must be from 0 to 0.5");
  CreepProblem problem = ellipseProblem(ellipse, creepage);
  problem.friction = friction;
  problem.elasticity = elasticity;
  CreepSolution solution;
  makeCreepSolver(method)->solve(problem, false, solution);
  refuseIf(solution.status == CreepStatus::invalid_problem, "creepage: must be finite");
  refuseIf<std::runtime_error>(!isUsable(solution.status), std::string("creep force: ") + toString(solution.status));
  return solution.force;
}
}  // namespace wheel_rail_contact::core
