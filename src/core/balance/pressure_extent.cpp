// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/pressure_extent.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
namespace
{
/// Distance of the edge from the centre of the outermost loaded cell, in cells, from the pressures of this cell and its
/// inner neighbour.
double reachBeyond(double outer, double inner)
{
  const double fall = inner * inner - outer * outer;
  return fall > outer * outer ? outer * outer / fall : 1.0;
}

void findCells(const Grid& grid, const Eigen::ArrayXXd& pressure, PressureExtent& extent)
{
  extent.first_column = static_cast<int>(pressure.cols());
  extent.first_row = static_cast<int>(pressure.rows());
  for (int j = 0; j < pressure.cols(); ++j)
  {
    const double* column = pressure.col(j).data();
    int first = 0;
    int last = static_cast<int>(pressure.rows()) - 1;
    while (first <= last && !(column[first] > 0))
    {
      ++first;
    }
    while (last >= first && !(column[last] > 0))
    {
      --last;
    }
    if (first <= last)
    {
      const auto cells =
          static_cast<int>(std::count_if(column + first, column + last + 1, [](double p) { return p > 0; }));
      extent.cells += grid.symmetric ? 2 * cells : cells;
      extent.first_column = std::min(extent.first_column, j);
      extent.last_column = j;
      extent.first_row = std::min(extent.first_row, first);
      extent.last_row = std::max(extent.last_row, last);
    }
  }
}
}  // namespace

PressureExtent findExtent(const Grid& grid, const Eigen::ArrayXXd& pressure)
{
  PressureExtent extent;
  findCells(grid, pressure, extent);
  if (extent.empty())
  {
    return extent;
  }
  const auto column_peak = [&](int j) { return j >= 0 && j < pressure.cols() ? pressure.col(j).maxCoeff() : 0.0; };
  const auto row_peak = [&](int i) { return i >= 0 && i < pressure.rows() ? pressure.row(i).maxCoeff() : 0.0; };
  const int left = extent.first_column;
  const int right = extent.last_column;
  extent.y_begin = grid.y(left) - grid.dy * reachBeyond(column_peak(left), column_peak(left + 1));
  extent.y_end = grid.y(right) + grid.dy * reachBeyond(column_peak(right), column_peak(right - 1));
  const int front = extent.last_row;
  const int back = extent.first_row;
  extent.half_length = grid.x(front) + grid.dx * reachBeyond(row_peak(front), row_peak(front - 1));
  if (!grid.symmetric)
  {
    const double behind = -grid.x(back) + grid.dx * reachBeyond(row_peak(back), row_peak(back + 1));
    extent.half_length = std::max(extent.half_length, behind);
  }
  return extent;
}
}  // namespace wheel_rail_contact::core
