// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/estimate/error_estimate.h"
#include "core/normal/measures/pressure_measures.h"
#include "core/normal/solvers/strip_area.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Strip method of Kik and Piotrowski (Piotrowski and Kik 2008, Vehicle System Dynamics 46, 27–48).
///
/// The contact area is the overlap of the undeformed bodies at 0.55 of the approach (their eq. 7). A strip at y has the
/// half-length l(y) = sqrt((0.55 approach - gap(y)) / A), where A is the coefficient of the gap along x. The pressure
/// on each strip is a half-ellipse proportional to its length, p = p0 sqrt(l² - x²) / l0. p0 follows from the
/// displacement at the deepest point, which must equal the approach (their eq. 13). Shape correction: the area is
/// stretched along and compressed across, or the reverse, with a constant product of length and width. Its ratio of
/// length to width is then that of the Hertz ellipse whose curvatures would give an overlap of the uncorrected length
/// and width.
///
/// Deviations from the paper:
/// * A is determined for each column of the gap, and strips may be shifted along x (yaw): their middle is the lowest
///   point of the column. The paper has A = 1 / (2 wheel radius) and symmetric strips. Displacements are computed for
///   unshifted strips.
/// * The inner integral of the displacement is computed in closed form (elliptic integrals). The rule for the outer
///   integral takes the root at the ends of the area and the logarithm at the deepest point into account.
/// * The ratio of the Hertz ellipse is computed in closed form, not from tables.
/// * Two lobes in one patch are one area with one displacement condition; its width is the sum of both.
/// Several patches share the approach. The approach that carries the load is found by a secant method on logarithms.
///
/// `iterations` counts evaluations of the load. `residual` is the remaining relative error of the load. The status is
/// no_positive_curvature (not usable) if the gap of a loaded strip does not open along x.
class KikPiotrowski : public NormalSolver
{
 public:
  using NormalSolver::solve;
  const char* name() const override { return "kik_piotrowski"; }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override;

  /// Estimates the errors from the bias of the method and from the difference between the overlap and that of the
  /// paraboloid with the same moments.
  void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                      std::vector<ErrorEstimate>& errors) const override;
  /// Terms of the estimate, which is their weighted sum.
  static ShapeTerms errorTerms(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch);

 private:
  bool fit(const NormalProblem& problem);
  SolveStatus findAreas(const NormalProblem& problem, NormalSolution& solution);
  bool loadAt(const NormalProblem& problem, double approach, double& load);
  SolveStatus findApproach(const NormalProblem& problem, NormalSolution& solution);
  double firstTouch(const NormalProblem& problem) const;

  std::vector<StripGap> gaps_;
  std::vector<StripArea> areas_;
  PressureMeasures measures_;
};
}  // namespace wheel_rail_contact::core
