// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Model of the displacement at the centre of one cell by the pressure of another cell.
enum class Kernel
{
  rectangle,   ///< constant pressure on the cell (exact)
  point_force  ///< force of the cell at its centre, as in the paper; exact on the cell itself
};

/// Integral of 1/rho over a rectangle dx × dy [m]. rho is the distance to the point (x, y), measured from the centre of
/// the rectangle.
///
/// A constant pressure p on the rectangle displaces this point by p / (pi E*) times the integral (Boussinesq 1885;
/// closed form: Love 1929; Johnson 1985, eq. 3.25). Far from the rectangle the closed form loses digits by
/// cancellation, and Gauss–Legendre quadrature of the same integral is used. The relative error is below 1e-12.
double rectangleInfluence(double x, double y, double dx, double dy);

/// Influence of the force of the cell at its centre [m]: dx dy / rho (Golubenko et al. 2011). On the cell itself this
/// is infinite, and the exact integral is used: 4 h ln(1 + sqrt 2) for a square of side h. The printed formula of the
/// paper lacks the factor h.
///
/// The matrix of these coefficients is indefinite on cells longer than 4.70 times their width.
double pointInfluence(double x, double y, double dx, double dy);

/// Influence by `kernel` [m]: rectangleInfluence() or pointInfluence().
double influence(Kernel kernel, double x, double y, double dx, double dy);

/// Influence coefficients of a grid by the distance of its cells, in units of dy (see InfluenceOperator). For
/// iterations that change one cell at a time.
class InfluenceTable
{
 public:
  /// Computes the table. Does nothing if the shape is that of the last call. Allocates only if the grid is larger than
  /// all previous ones.
  void set(const Grid& grid, Kernel kernel);

  /// Displacement of a cell in this row by a unit pressure on itself (on a symmetric grid: and on its mirror image).
  double own(int row) const;

  /// Adds the displacement by a pressure `amount` in cell (row, column) to `displacement` (rows × ny, x fastest).
  void add(int row, int column, double amount, double* displacement) const;

 private:
  /// Coefficient at `distance` columns and 0 rows. Those of other rows are stored before and after it.
  const double* atColumnDistance(int distance) const
  {
    return table_.data() + static_cast<std::size_t>(distance * line_ + rows_ - 1);
  }

  std::vector<double> table_;  ///< [column distance][row distance from -(rows - 1)]
  int rows_ = 0, columns_ = 0, line_ = 0;
  bool symmetric_ = false;
  double aspect_ = 0;
  Kernel kernel_ = Kernel::rectangle;
};
}  // namespace wheel_rail_contact::core
