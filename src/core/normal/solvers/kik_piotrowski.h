// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/normal/estimate/error_estimate.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Kik and Piotrowski's strip method (Piotrowski and Kik 2008, Vehicle System Dynamics 46, 27–48).
///
/// The contact area is taken from the overlap of the undeformed bodies at 0.55 of the approach (their eq. 7): a strip
/// at y reaches over l(y) = sqrt((0.55 approach - gap(y)) / A), A being the gap's coefficient along x. On each strip
/// the pressure is a half-ellipse proportional to its length, p = p0 sqrt(l² - x²) / l0, and p0 follows from the
/// displacement at the deepest point, which must equal the approach (their eq. 13). Shape correction: the area is
/// stretched along and squeezed across (or the other way round), its length times width kept, until its length over its
/// width is that of the Hertz ellipse whose curvatures would give an overlap of the uncorrected length and width.
///
/// Where this deviates from the paper:
/// * A is taken from each column of the gap, and strips may lie askew (yaw): their middle is the column's lowest place.
///   The paper has A = 1 / (2 wheel radius) and symmetric strips. Displacements are computed as if not askew.
/// * The inner integral of the displacement is done in closed form (elliptic integrals), the outer one by a rule that
///   takes care of the root at the area's ends and of the logarithm at the deepest point.
/// * The ratio of the Hertz ellipse comes from the closed form, not from tables.
/// * Two lobes in one patch are one area with one displacement condition; width is the sum of both.
/// Several patches share the approach; the approach that carries the load is found by a secant on logarithms.
///
/// iterations counts evaluations of the load, residual is the relative error of the load that is left. Status
/// no_positive_curvature (not usable) where a loaded strip's gap does not open along x.
class KikPiotrowski : public NormalSolver
{
 public:
  KikPiotrowski();
  ~KikPiotrowski() override;
  KikPiotrowski(KikPiotrowski&&) noexcept;
  KikPiotrowski& operator=(KikPiotrowski&&) noexcept;

  const char* name() const override { return "kik_piotrowski"; }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override;

  /// From the method's own bias, and from what tells the overlap from that of the paraboloid of the same moments.
  void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                      std::vector<ErrorEstimate>& errors) const override;
  /// What the estimate is a weighted sum of, beside the method's bias.
  static ShapeTerms errorTerms(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch);

 private:
  struct Workshop;
  std::unique_ptr<Workshop> workshop_;
};
}  // namespace wheel_rail_contact::core
