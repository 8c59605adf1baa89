// SPDX-License-Identifier: BSD-3-Clause
// Solves the normal problem of one patch between two paraboloids, without wheel, rail or ROS, and compares the highest
// pressure with Hertz.
#include <cmath>
#include <iostream>
#include <memory>

#include "wheel_rail_contact/core/normal_solver.h"

int main()
{
  using namespace wheel_rail_contact::core;

  constexpr double radius = 0.3;  // of the undeformed gap: x^2 / (2 R) + y^2 / (2 R) [m]
  constexpr double load = 1e5;    // [N]

  PatchGap patch;
  patch.grid.nx = patch.grid.ny = 32;
  patch.grid.dx = patch.grid.dy = 0.6e-3;
  patch.grid.y0 = -0.5 * (patch.grid.ny - 1) * patch.grid.dy;
  patch.gap.resize(patch.grid.rows(), patch.grid.ny);
  for (int j = 0; j < patch.grid.ny; ++j)
  {
    for (int i = 0; i < patch.grid.rows(); ++i)
    {
      patch.gap(i, j) = (std::pow(patch.grid.x(i), 2) + std::pow(patch.grid.y(j), 2)) / (2 * radius);
    }
  }

  NormalProblem problem;
  problem.patches = {patch};
  problem.modulus = contactModulus(Material(), Material());
  problem.value = load;
  NormalSolution solution;
  const std::unique_ptr<NormalSolver> solver = makeNormalSolver(NormalMethod::conjugate_gradient);
  solver->solve(problem, false, solution);

  // Johnson 1985, eq. 4.24: p0 = (6 P E*^2 / (pi^3 R^2))^(1/3).
  const double pi = std::acos(-1.0);
  const double hertz = std::cbrt(6 * load * std::pow(problem.modulus, 2) / (std::pow(pi, 3) * std::pow(radius, 2)));
  const double found = solution.patches.at(0).max_pressure;
  std::cout << toString(solution.status) << ": " << found << " Pa, Hertz " << hertz << " Pa\n";
  return isUsable(solution.status) && std::abs(found / hertz - 1) < 0.01 ? 0 : 1;
}
