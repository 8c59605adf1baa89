// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Methods for the normal contact problem. doc/methods.md compares them.
enum class NormalMethod
{
  automatic,           ///< conjugate gradients on the cheapest grid whose estimated error meets the tolerance
  hertz,               ///< Hertz's closed form with the local curvatures
  kik_piotrowski,      ///< approximate strip method (Piotrowski and Kik 2008)
  seidel,              ///< iteration of Golubenko et al. 2011, repaired: exact coefficients, load held in the iteration
  seidel_printed,      ///< iteration of Golubenko et al. 2011 as printed: point forces, load steps
  conjugate_gradient,  ///< bound-constrained conjugate gradients on one grid
};

/// All methods.
constexpr std::array<NormalMethod, 6> all_normal_methods{
    NormalMethod::automatic, NormalMethod::hertz,          NormalMethod::kik_piotrowski,
    NormalMethod::seidel,    NormalMethod::seidel_printed, NormalMethod::conjugate_gradient};

/// Name of the method, as in the parameter `contact/method`; a string with static lifetime.
const char* toString(NormalMethod method);

/// Method by its name.
/// @throw std::invalid_argument with the name if there is no such method.
NormalMethod methodNamed(std::string_view name);

/// Solver for the normal contact problem: its input is a gap for each patch and the contact modulus, independent of any
/// wheel or rail. An object may keep memory between solutions and is not thread-safe.
class NormalSolver
{
 public:
  virtual ~NormalSolver() = default;

  /// Name of the method, as in the parameter `contact/method`.
  virtual const char* name() const = 0;

  /// Solves `problem`. If `warm` is true and `solution` contains a usable pressure of the same shapes, the solver
  /// starts from it. For shapes that it has solved before, it allocates no memory. Does not throw for a numerical
  /// failure: check NormalSolution::status.
  virtual void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) = 0;
  /// Curved surfaces require solveCurved().
  void solve(const CurvedProblem& problem, bool warm, NormalSolution& solution) = delete;

  /// Solves a problem on curved surfaces. The default implementation solves it as a NormalProblem, with one normal for
  /// each patch, and leaves out the rest.
  virtual void solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution);

  /// What solveCurved() leaves out of this problem: "column normals" and "patch coupling"; empty: nothing. A string
  /// with static lifetime.
  virtual std::string_view leftOut(const CurvedProblem& problem) const;

  /// Estimates the errors of each patch of a usable solution of this method; zero for a patch without pressure.
  /// `errors` is resized to the number of patches. The default implementation is for methods that compute a pressure in
  /// each cell.
  virtual void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                              std::vector<ErrorEstimate>& errors) const;
};

/// Creates a solver of the given method, with default options.
/// @throw std::invalid_argument for NormalMethod::automatic: it chooses a grid for each wheel and therefore requires a
/// WheelsetContact.
std::unique_ptr<NormalSolver> makeNormalSolver(NormalMethod method);
}  // namespace wheel_rail_contact::core
