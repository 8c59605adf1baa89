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

/// Changes of a row, and a row on which they act.
struct RowProduct
{
  int first = 0, end = 0;                             ///< columns of the source
  const double *step_x = nullptr, *step_y = nullptr;  ///< changes there [Pa]
  int target_first = 0, target_end = 0;               ///< columns of the target
  double *slip_x = nullptr, *slip_y = nullptr;        ///< its slip, to which is added
  TangentialTable::Row influence;
};
void addProduct(const RowProduct& product);
}  // namespace wheel_rail_contact::core
