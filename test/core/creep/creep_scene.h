// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../usual_headers.h"
#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact::core
{
/// Elliptic contacts on 24 × 24 cells with 100 kN and a friction of 0.3.
struct CreepScene
{
  static constexpr double friction_limit = 3e4;  ///< [N]
  double a = 0.006, b = 0.005;

  CreepProblem problem(const Creepage& creepage) const { return ellipseProblem({a, b, 1e5, 24, 24}, creepage); }
  CreepSolution solve(CreepMethod method, const Creepage& creepage) const { return solve(method, problem(creepage)); }
  static CreepSolution solve(CreepMethod method, const CreepProblem& problem)
  {
    CreepSolution solution;
    makeCreepSolver(method)->solve(problem, false, solution);
    return solution;
  }
};

constexpr CreepMethod creeping_methods[] = {CreepMethod::linear, CreepMethod::fastsim, CreepMethod::exact};
}  // namespace wheel_rail_contact::core
