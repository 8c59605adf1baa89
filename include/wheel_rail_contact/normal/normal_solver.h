// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

  /// Solves `problem` into `solution`. When `warm` is set and `solution` holds a usable pressure of the same shapes, it
  /// is the starting point. Neither allocates once the shapes have been seen. Never throws for numerical failure: the
  /// status tells.
  virtual void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) = 0;
};
}  // namespace wheel_rail_contact
