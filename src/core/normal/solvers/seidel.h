// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/normal/estimate/error_estimate.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Form of the iteration and its stopping criteria.
struct SeidelOptions
{
  /// The iteration as printed in the paper, or repaired.
  enum class Form
  {
    printed,  ///< point forces, approach in steps, stop at a small change; load by secant steps on the approach
    repaired  ///< exact coefficients, load held within the iteration, stop at a small residual
  };
  Form form = Form::repaired;  ///< form of the iteration
  /// Repaired: residual at which the solution is regarded as converged, defined as in ConjugateGradients [-], in (0,
  /// 1).
  double residual = 1e-4;
  /// Printed: root mean square change of the pressure in one sweep over its root mean square, at which a step ends [-],
  /// in (0, 1).
  double change = 1e-4;
  /// Printed: number of steps in which the approach is applied, > 0.
  int load_steps = 5;
  /// Printed: relative error of the load at which the secant steps end [-], in (0, 1).
  double load_error = 1e-4;
  /// Largest number of sweeps over all cells in one solution, > 0.
  int max_sweeps = 20000;
};

/// Nonlinear Seidel iteration of Golubenko, Kostyukevich, Tsyganovskiy and Nozhenko 2011 (TEKA XI, 78–84). Cell by cell
/// it sets p = max(p - w / a_own, 0), with the new pressures of the cells before. It works on any grid of the
/// interface, not only on square cells. It is slow: the cost of a sweep is proportional to the square of the number of
/// cells.
///
/// Printed form: a cell acts on other cells by its force at its centre, and on itself exactly (the printed 4 c1 ln(1 +
/// sqrt 2) lacks the side h of the square). The approach is applied in equal steps, each of which starts from the
/// pressure of the previous one. A step ends when the root mean square change of the pressure is small. On fine grids
/// this occurs before the error is small. The paper does not state how the load is met; here the approach is found by
/// secant steps. An earlier solution is not used. On cells longer than 4.70 times their width the matrix is indefinite.
/// The status is `indefinite` if this is detected, in a sweep or as stripes on the box around the pressure, even if
/// the iteration itself has converged.
///
/// Repaired form: exact rectangle coefficients, which are positive definite on cells of any shape. After each sweep the
/// pressure is scaled to the load, and the approach is computed from the loaded cells.
class Seidel : public NormalSolver
{
 public:
  using NormalSolver::solve;
  /// @throw std::invalid_argument with the option, its value and the broken rule.
  explicit Seidel(const SeidelOptions& options = {});
  ~Seidel() override;
  Seidel(Seidel&&) noexcept;
  Seidel& operator=(Seidel&&) noexcept;

  const char* name() const override;
  /// `iterations` of the solution is the number of sweeps.
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override;

  /// Printed form: the errors of the grid plus those of the point forces.
  void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                      std::vector<ErrorEstimate>& errors) const override;

 private:
  class Sweeps;
  std::unique_ptr<Sweeps> sweeps_;
};

/// Errors of a solution with point forces in addition to those of its grid, in a patch with pressure.
///
/// They are multiples of the bias over the approach. The factors were fitted once, by a program that is not kept, to
/// 882 random contacts on grids of 4 × 16 to 12 × 32 cells. Together with the grid errors, the largest estimate was at
/// least the true error in 98 % of them. test/core/normal/error_estimate_test.cpp requires 95 % on other contacts. The
/// factors are not valid for cells so long that the matrix is indefinite (more than 4.70 times their width).
ErrorEstimate pointForceErrors(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch);

/// Energy, up to a factor, of point forces with alternating sign from column to column on the smallest box of cells
/// around `pressure` (in the order of the gap arrays). A negative value means that the influence matrix is indefinite,
/// because the cells are too long.
double stripeEnergy(const Grid& grid, const double* pressure);
}  // namespace wheel_rail_contact::core
