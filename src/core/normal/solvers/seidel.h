// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Form of the iteration, and when it ends.
struct SeidelOptions
{
  /// The iteration as the paper has it, or repaired.
  enum class Form
  {
    printed,  ///< point forces, approach in steps, stop at a small change; load by secant steps on the approach
    repaired  ///< exact coefficients, load held inside the iteration, stop at a small residual
  };
  Form form = Form::repaired;  ///< which of the two
  /// Repaired: residual, as that of ConjugateGradients, at which the solution counts as converged [-], in (0, 1).
  double residual = 1e-4;
  /// Printed: root mean square change of the pressure in one sweep at which a step ends, over its root mean square [-],
  /// in (0, 1).
  double change = 1e-4;
  /// Printed: steps in which the approach is applied, > 0.
  int load_steps = 5;
  /// Printed: relative error of the load that ends the secant steps [-], in (0, 1).
  double load_error = 1e-4;
  /// Largest number of sweeps over all cells in one solve, > 0.
  int max_sweeps = 20000;
};

/// The nonlinear Seidel iteration of Golubenko, Kostyukevich, Tsyganovskiy and Nozhenko 2011 (TEKA XI, 78–84): cell by
/// cell p = max(p - w / a_own, 0), each cell at once using what the cells before it have become. Any grid of the
/// interface, not only square cells. Slow: a sweep costs the square of the number of cells.
///
/// Printed: influence of a cell on others by its force at its centre, on itself exactly (the print's 4 c1 ln(1 + sqrt
/// 2) lacks the side h of the square). The approach is applied in equal steps, each starting from the last one's
/// pressure, and a step ends when the pressure's root mean square change is small, which on fine grids comes before the
/// error is small. The paper does not say how it meets a load; here the approach is found by secant steps. An earlier
/// solution is not used. On cells longer than 4.70 times their width the matrix has negative directions: the status is
/// then `indefinite` if one has shown itself, in a sweep or as stripes on the box around the pressure, though the
/// iteration comes to its own end.
///
/// Repaired: exact rectangle coefficients, positive definite on cells of any shape; after each sweep the pressure is
/// scaled to the load and the approach follows from the loaded cells.
class Seidel : public NormalSolver
{
 public:
  /// @throw std::invalid_argument naming the option, its value and the broken rule.
  explicit Seidel(const SeidelOptions& options = {});
  ~Seidel() override;
  Seidel(Seidel&&) noexcept;
  Seidel& operator=(Seidel&&) noexcept;

  const char* name() const override;
  /// `iterations` of the solution counts sweeps.
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override;

  /// Printed: the grid's errors and those that come from putting the cells' forces into their centres.
  void estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                      std::vector<ErrorEstimate>& errors) const override;

 private:
  class Sweeps;
  std::unique_ptr<Sweeps> sweeps_;
};
}  // namespace wheel_rail_contact::core
