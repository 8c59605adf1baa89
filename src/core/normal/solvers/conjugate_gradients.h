// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// When the iteration ends.
struct ConjugateGradientsOptions
{
  /// Residual at which the solution counts as converged [-], in (0, 1).
  double residual = 1e-4;
  /// Largest number of products with the influence matrix, > 0.
  int max_products = 200;
};

/// Bound-constrained, preconditioned conjugate gradients with exact rectangle coefficients.
///
/// Idea: Vollebregt 2014 (J. Comput. Phys. 257, bound-constrained CG); load control by projection: Polonsky and Keer
/// 1999 (Wear 231). Differences: the step is aimed at the bounds before its one product is made (the search goes along
/// the chord to the clipped trial point), so that every iterate satisfies p >= 0 and the load exactly, the energy falls
/// monotonically and each iteration costs one product.
///
/// A support that yields adds to A the matrix opening * compliance * opening^T, of rank three. The depth below is then
/// that of the bodies with the support where it has yielded to, as far as its mean way under the pressure goes.
///
/// Residual: with w = A p + gap - weight * approach,
///   max( max of |w| where p > 0, max of -w where p = 0 ) / max over all cells of (weight * approach - gap),
/// that is, the largest violation of the contact conditions over the largest depth of interpenetration of the
/// undeformed bodies. p >= 0 and (load control) sum(weight * force) = load hold to rounding. In load control the
/// approach is the mean of (A p + gap) / weight over the loaded cells, weighted by weight² times the cell's area.
class ConjugateGradients : public NormalSolver
{
 public:
  /// @throw std::invalid_argument naming the option, its value and the broken rule.
  explicit ConjugateGradients(const ConjugateGradientsOptions& options = {});
  ~ConjugateGradients() override;
  ConjugateGradients(ConjugateGradients&&) noexcept;
  ConjugateGradients& operator=(ConjugateGradients&&) noexcept;

  const char* name() const override { return "conjugate_gradient"; }
  bool solvesSupport() const override { return true; }

  /// Computes all coefficients that a grid of this many cells needs, symmetric or not, for patches of any usual shape
  /// (see OperatorCache) whose cell aspect is on the ladder (aspect_ladder.h): later solves on such grids compute no
  /// coefficient, and allocate only where they meet a larger problem than all before.
  /// @throw std::invalid_argument for a size that no grid can have.
  void prepare(int nx, int ny);

  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override;

 private:
  struct Workshop;
  std::unique_ptr<Workshop> workshop_;
};
}  // namespace wheel_rail_contact::core
