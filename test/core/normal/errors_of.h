// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Estimated errors of each patch of a solution.
inline std::vector<ErrorEstimate> errorsOf(const NormalSolver& solver, const NormalProblem& problem,
                                           const NormalSolution& solution)
{
  std::vector<ErrorEstimate> errors;
  solver.estimateErrors(problem, solution, errors);
  return errors;
}
}  // namespace wheel_rail_contact::core
