// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Stopping criteria of the iteration.
struct ConjugateGradientsOptions
{
  /// Residual at which the solution is regarded as converged [-], in (0, 1).
  double residual = 1e-4;
  /// Largest number of products with the influence matrix, > 0.
  int max_products = 200;
};

/// Bound-constrained, preconditioned conjugate gradients with exact rectangle coefficients.
///
/// Basis: Vollebregt 2014 (J. Comput. Phys. 257, bound-constrained CG); load control by projection: Polonsky and Keer
/// 1999 (Wear 231). Difference: the bounds are applied before the only product of an iteration is computed. The search
/// follows the chord to the clipped trial point. Every iterate therefore satisfies p >= 0 and the load exactly, the
/// energy decreases monotonically, and each iteration costs one product.
///
/// Residual: with w = A p + gap - weight * approach,
///   max( max of |w| where p > 0, max of -w where p = 0 ) / max over all cells of (weight * approach - gap).
/// This is the largest violation of the contact conditions over the largest interpenetration of the undeformed bodies.
/// p >= 0 and (load control) sum(weight * force) = load hold to rounding. In load control the approach is the mean of
/// (A p + gap) / weight over the loaded cells, weighted with weight² times the cell area.
class ConjugateGradients : public NormalSolver
{
 public:
  /// @throw std::invalid_argument with the option, its value and the broken rule.
  explicit ConjugateGradients(const ConjugateGradientsOptions& options = {});
  ~ConjugateGradients() override;
  ConjugateGradients(ConjugateGradients&&) noexcept;
  ConjugateGradients& operator=(ConjugateGradients&&) noexcept;

  const char* name() const override { return "conjugate_gradient"; }

  /// Computes all coefficients for grids of this size, symmetric or not, for patches of all usual shapes (see
  /// OperatorCache) whose cell aspect is in the series of cell_aspect. Later solutions on such grids compute no
  /// coefficient. They allocate memory only if a problem is larger than all previous ones.
  /// @throw std::invalid_argument for an invalid size.
  void prepare(int nx, int ny);

  using NormalSolver::solve;
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override;
  void solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution) override;
  std::string_view leftOut(const CurvedProblem& /*problem*/) const override { return {}; }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace wheel_rail_contact::core
