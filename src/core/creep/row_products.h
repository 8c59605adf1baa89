// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/creep/tangential_influence.h"

namespace wheel_rail_contact::core
{
/// A row of cells during its solution.
struct RowCells
{
  int first = 0, end = 0;             ///< columns that are solved
  const double* bound = nullptr;      ///< friction limit of each cell [Pa]
  double *x = nullptr, *y = nullptr;  ///< tractions [Pa]
  double *slip_x = nullptr, *slip_y = nullptr;
  double *step_x = nullptr, *step_y = nullptr;  ///< changes, which are added up
  TangentialTable::Row influence;               ///< of the cells of a row on one another
};

/// Solves the cells of a row one after another, to and fro. Adds the changes to traction, slip and step.
void solveRow(const RowCells& row);

/// Changes of a row, and two rows on which they act, at the same distance behind and ahead.
struct RowProduct
{
  const int* columns = nullptr;                       ///< those with a change
  int count = 0;                                      ///< their number
  const double *step_x = nullptr, *step_y = nullptr;  ///< changes of all columns [Pa]
  int target_first = 0, target_end = 0;               ///< columns of the targets; nothing is added without any
  double *behind_x = nullptr, *behind_y = nullptr, *ahead_x = nullptr, *ahead_y = nullptr;  ///< slip, to which is added
  TangentialTable::Row influence;                                                           ///< on the row behind
};
void addProduct(const RowProduct& product);
}  // namespace wheel_rail_contact::core
