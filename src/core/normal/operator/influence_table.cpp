// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/influence_table.h"

#include <cstdlib>

namespace wheel_rail_contact::core
{
void InfluenceTable::set(const Grid& grid, Kernel kernel)
{
  const double aspect = grid.dx / grid.dy;
  if (rows_ == grid.rows() && columns_ == grid.ny && symmetric_ == grid.symmetric && aspect_ == aspect &&
      kernel_ == kernel)
  {
    return;
  }
  rows_ = grid.rows();
  columns_ = grid.ny;
  symmetric_ = grid.symmetric;
  aspect_ = aspect;
  kernel_ = kernel;
  line_ = symmetric_ ? 3 * rows_ - 1 : 2 * rows_ - 1;
  table_.resize(static_cast<std::size_t>(columns_ * line_));
  double* coefficient = table_.data();
  for (int column = 0; column < columns_; ++column)
  {
    for (int row = 1 - rows_; row < line_ - rows_ + 1; ++row)
    {
      *coefficient++ = influence(kernel, row * aspect, column, aspect, 1);
    }
  }
}

double InfluenceTable::own(int row) const
{
  const double* direct = atColumnDistance(0);
  return direct[0] + (symmetric_ ? direct[2 * row + 1] : 0);
}

void InfluenceTable::add(int row, int column, double amount, double* displacement) const
{
  for (int j = 0; j < columns_; ++j, displacement += rows_)
  {
    const double* direct = atColumnDistance(std::abs(j - column)) - row;
    for (int i = 0; i < rows_; ++i)
    {
      displacement[i] += amount * direct[i];
    }
    if (symmetric_)
    {
      const double* mirrored = direct + 2 * row + 1;
      for (int i = 0; i < rows_; ++i)
      {
        displacement[i] += amount * mirrored[i];
      }
    }
  }
}
}  // namespace wheel_rail_contact::core
