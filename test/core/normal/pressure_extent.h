// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core::scenes
{
/// Position of a pressure in its grid. Along each direction, an edge is where the square of the peak pressure of the
/// rows or columns, extrapolated from the two outermost loaded ones, falls to zero. The square is linear in the
/// distance from the edge of any smooth contact.
struct PressureExtent
{
  double y_begin = 0, y_end = 0;  ///< edges across the track [m]
  double half_length = 0;         ///< largest |x| of the edges along the track [m]

  /// True if the edge at y_begin lies outside the grid, which then cuts the contact off.
  bool cutBegin(const Grid& grid) const { return y_begin < grid.y(0) - 0.5 * grid.dy; }
  /// Same for the edge at y_end.
  bool cutEnd(const Grid& grid) const { return y_end > grid.y(grid.ny - 1) + 0.5 * grid.dy; }
  /// Same for the edges along the track.
  bool cutLength(const Grid& grid) const { return half_length > 0.5 * grid.nx * grid.dx; }
  /// True if any edge is cut off.
  bool cut(const Grid& grid) const { return cutBegin(grid) || cutEnd(grid) || cutLength(grid); }
};

/// Distance of the edge from the centre of the outermost loaded cell, in cells, from the pressures of this cell and its
/// inner neighbour.
inline double reachBeyond(double outer, double inner)
{
  const double fall = inner * inner - outer * outer;
  return fall > outer * outer ? outer * outer / fall : 1.0;
}

/// First and last element that is positive, and the distances of the edges from them, in cells.
struct PositiveRange
{
  explicit PositiveRange(const Eigen::ArrayXd& peaks)
  {
    const auto at = [&](Eigen::Index i) { return i >= 0 && i < peaks.size() ? peaks[i] : 0.0; };
    while (first < peaks.size() && !(peaks[first] > 0))
    {
      ++first;
    }
    last = peaks.size() - 1;
    while (last > first && !(peaks[last] > 0))
    {
      --last;
    }
    before = reachBeyond(at(first), at(first + 1));
    after = reachBeyond(at(last), at(last - 1));
  }
  Eigen::Index first = 0, last = 0;
  double before = 0, after = 0;
};

/// Extent of a pressure [Pa] that is positive somewhere, given on the stored cells of its grid.
inline PressureExtent findExtent(const Grid& grid, const Eigen::ArrayXXd& pressure)
{
  const PositiveRange columns(pressure.colwise().maxCoeff().transpose()), rows(pressure.rowwise().maxCoeff());
  PressureExtent extent;
  extent.y_begin = grid.y(static_cast<int>(columns.first)) - grid.dy * columns.before;
  extent.y_end = grid.y(static_cast<int>(columns.last)) + grid.dy * columns.after;
  extent.half_length = grid.x(static_cast<int>(rows.last)) + grid.dx * rows.after;
  if (!grid.symmetric)
  {
    const double behind = -grid.x(static_cast<int>(rows.first)) + grid.dx * rows.before;
    extent.half_length = std::max(extent.half_length, behind);
  }
  return extent;
}
}  // namespace wheel_rail_contact::core::scenes
