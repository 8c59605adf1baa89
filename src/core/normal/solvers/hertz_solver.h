// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/estimate/error_estimate.h"
#include "core/normal/measures/pressure_measures.h"
#include "core/normal/solvers/hertz.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Paraboloid that represents a gap near its lowest point.
struct GapMinimum
{
  double gap = 0;          ///< gap at the lowest point [m]
  double x = 0, y = 0;     ///< position of the lowest point [m]
  double angle = 0;        ///< from the x axis to the first principal direction [rad], in (-pi/2, pi/2]
  GapCurvature curvature;  ///< along the first and second principal directions [1/m]

  /// True if both curvatures are positive.
  bool isPositive() const { return curvature.a > 0 && curvature.b > 0; }
};

/// Paraboloid through the lowest cell and its eight neighbours. Its lowest point may lie between the cells, at most one
/// cell from the lowest one; on a symmetric grid it lies at x = 0. Requires 3 × 3 cells (symmetric: 2 stored rows).
GapMinimum fitMinimum(const PatchGap& gap);

/// Difference between the part of a gap below a level and that of a paraboloid, both on the cells of the gap.
struct OverlapMismatch
{
  double volume = 0;  ///< |ln(ratio of the volumes)| [-]
  double shape = 0;   ///< volume that is not common to both, over the mean of both [-], 0 … 2
};

OverlapMismatch compareOverlap(const PatchGap& gap, const GapMinimum& paraboloid, double level);

/// Hertz's closed form with the curvatures of each gap at its lowest point.
///
/// Several patches share the approach. Their forces are summed in closed form, and the approach that carries the load
/// is found by Newton's method. max_pressure, area, force and approach are those of the ellipses. `pressure` contains
/// the means of the ellipsoid over the cells; they sum to the force. If the grid cuts the ellipse (touches_border), the
/// part beyond the border is distributed over the loaded cells. It is omitted if the cells would then exceed
/// max_pressure. The residual is zero, because nothing is iterated on cells. The status is no_positive_curvature (not
/// usable) if the curvatures of a patch are not positive.
class HertzSolver : public NormalSolver
{
 public:
  using NormalSolver::solve;
  const char* name() const override { return "hertz"; }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override;

  /// Estimates the errors from the difference between the overlap and that of the paraboloid at the lowest point of the
  /// gap, at half the approach and at the full approach. `solution` may be the solution of the same problem by another
  /// method. The estimate then predicts the error of Hertz's solution. It is infinite if the curvatures of a loaded
  /// patch are not positive.
  void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                      std::vector<ErrorEstimate>& errors) const override;
  /// Terms of the estimate, which is their weighted sum.
  static ShapeTerms errorTerms(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch);

 private:
  struct Ellipse
  {
    GapMinimum minimum;
    HertzContact unit;  ///< at an approach of 1 m
  };
  SolveStatus fit(const NormalProblem& problem);
  double approachForLoad(const NormalProblem& problem) const;

  std::vector<Ellipse> ellipses_;
  PressureMeasures measures_;
};
}  // namespace wheel_rail_contact::core
