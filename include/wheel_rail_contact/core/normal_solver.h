// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Methods for the normal problem.
enum class NormalMethod
{
  automatic,           ///< Hertz between round bodies, else the cheapest grid whose estimated error meets the tolerance
  hertz,               ///< closed form with the local curvatures
  kik_piotrowski,      ///< strips over the virtual penetration
  seidel,              ///< the paper's iteration, repaired: exact coefficients, load inside
  seidel_printed,      ///< the paper's iteration as printed: point forces, load steps
  conjugate_gradient,  ///< on one grid
};

/// All of them.
constexpr std::array<NormalMethod, 6> all_normal_methods{
    NormalMethod::automatic, NormalMethod::hertz,          NormalMethod::kik_piotrowski,
    NormalMethod::seidel,    NormalMethod::seidel_printed, NormalMethod::conjugate_gradient};

/// Name as in the parameter `contact/method`, alive as long as the program.
const char* toString(NormalMethod method);

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

  /// Estimated errors of each patch of a usable solution found by this method; zero for a patch without pressure.
  /// `errors` is resized to the number of patches. The default suits methods that solve for a pressure in each cell.
  virtual void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                              std::vector<ErrorEstimate>& errors) const;
};

/// A solver for the given method, with the method's default options.
/// @throw std::invalid_argument for NormalMethod::automatic, which chooses a grid for each wheel and therefore needs a
/// wheelset: use WheelsetContact, or one of the other methods.
std::unique_ptr<NormalSolver> makeNormalSolver(NormalMethod method);
}  // namespace wheel_rail_contact::core
