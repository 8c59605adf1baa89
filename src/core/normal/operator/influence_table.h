// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/operator/influence.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Influence coefficients of a grid by the distance of its cells, in units of dy (see InfluenceOperator), for
/// iterations that change one cell at a time.
class InfluenceTable
{
 public:
  /// Computes the table; allocates only if the grid is larger than all before, and does nothing if its shape is the
  /// same.
  void set(const Grid& grid, Kernel kernel);

  /// Displacement of cell (row, column) by a unit pressure on itself (and its mirror image).
  double own(int row) const;

  /// Adds to `displacement` (rows × ny, x fastest) that of a pressure `amount` in cell (row, column).
  void add(int row, int column, double amount, double* displacement) const;

 private:
  /// Coefficients at `distance` columns and 0 rows; those of other rows lie around it.
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
