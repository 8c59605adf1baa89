// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/normal/error_estimate.h"
#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// A method for the normal contact problem. It knows gaps and a modulus, never a wheel.
class NormalSolver
{
 public:
  virtual ~NormalSolver() = default;

  /// Name as in the parameter `contact/method`.
  virtual const char* name() const = 0;

  /// True if a support that yields (NormalProblem::support) is solved together with the contact.
  virtual bool solvesSupport() const { return false; }

  /// Solves `problem` into `solution`. When `warm` is set and `solution` holds a usable pressure of the same shapes, it
  /// is the starting point. Neither allocates once the shapes have been seen. Never throws for numerical failure: the
  /// status tells.
  virtual void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) = 0;

  /// Estimated errors of each patch of a usable solution that this method found, against the exact answer; zero for a
  /// patch without pressure. `errors` gets one for each patch. As it stands here: for methods that put pressure on the
  /// grid's cells (estimateGridErrors).
  virtual void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                              std::vector<ErrorEstimate>& errors) const
  {
    estimateGridErrors(problem, solution, errors);
  }
};
}  // namespace wheel_rail_contact
