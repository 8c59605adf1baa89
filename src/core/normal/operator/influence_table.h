// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/operator/influence.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
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
