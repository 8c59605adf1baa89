// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/solvers/hertz.h"
#include "core/normal/estimate/error_estimate.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// A gap near its lowest place, as a paraboloid.
struct GapMinimum
{
  double gap = 0;          ///< there [m]
  double x = 0, y = 0;     ///< place [m]
  double angle = 0;        ///< from the x axis to the first principal direction [rad], in (-pi/2, pi/2]
  GapCurvature curvature;  ///< along the first and the second principal direction [1/m]

  /// True if the paraboloid is a bowl.
  bool isPositive() const { return curvature.a > 0 && curvature.b > 0; }
};

/// The paraboloid through the lowest cell and its eight neighbours; its lowest place may lie between the cells, at most
/// one cell from the lowest. On a symmetric grid it lies at x = 0. Needs 3 × 3 cells (symmetric: 2 stored rows).
GapMinimum fitMinimum(const PatchGap& gap);

/// Hertz's closed form with the curvatures that each gap has at its lowest place.
///
/// Several patches share the approach: their forces are summed in closed form, and the approach that carries the load
/// is found by Newton's method. max_pressure, area, force and approach are those of the ellipses; `pressure` holds the
/// ellipsoid's means over the cells, which sum up to the force. Where touches_border says that the grid cuts the
/// ellipse off, the part beyond is spread over the loaded cells, or left out if below max_pressure they have no room
/// for it. The residual is zero: nothing is iterated on cells. Status no_positive_curvature (not usable) where a
/// patch's gap is no bowl.
class HertzSolver : public NormalSolver
{
 public:
  const char* name() const override { return "hertz"; }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override;

  /// From what tells the overlap at half the approach, and at all of it, from that of the paraboloid at the gap's
  /// lowest place. `solution` may be another method's of the same problem: the estimate then tells what Hertz would
  /// leave; infinite where a loaded patch's gap is no bowl.
  void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                      std::vector<ErrorEstimate>& errors) const override;
  /// True if every patch of a valid problem has cells enough and is a bowl, loaded or not: solve() then does not refuse
  /// it.
  static bool canSolve(const NormalProblem& problem);
  /// What the estimate is a weighted sum of.
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
};
}  // namespace wheel_rail_contact::core
