// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Position of a pressure in its grid. Along each direction, an edge is where the square of the peak pressure of the
/// rows or columns, extrapolated from the two outermost loaded ones, falls to zero. The square is linear in the
/// distance from the edge of any smooth contact.
struct PressureExtent
{
  int cells = 0;                           ///< loaded cells of the whole grid
  int first_column = 0, last_column = -1;  ///< loaded columns
  int first_row = 0, last_row = -1;        ///< loaded rows
  double y_begin = 0, y_end = 0;           ///< edges across the track, patch frame [m]
  double half_length = 0;                  ///< largest |x| of the edges along the track [m]

  /// True if no cell carries pressure.
  bool empty() const { return cells == 0; }
  /// True if one or two cells carry the pressure: too few to determine its edges.
  bool spike() const { return cells > 0 && cells < 3; }
  /// True if the edge at y_begin lies outside the grid, which then cuts the contact off.
  bool cutBegin(const Grid& grid) const { return y_begin < grid.y(0) - 0.5 * grid.dy; }
  /// Same for the edge at y_end.
  bool cutEnd(const Grid& grid) const { return y_end > grid.y(grid.ny - 1) + 0.5 * grid.dy; }
  /// Same for the edges along the track.
  bool cutLength(const Grid& grid) const { return half_length > 0.5 * grid.nx * grid.dx; }
  /// True if any edge is cut off.
  bool cut(const Grid& grid) const { return cutBegin(grid) || cutEnd(grid) || cutLength(grid); }
};

/// Extent of a pressure [Pa], given on the stored cells of its grid.
PressureExtent findExtent(const Grid& grid, const Eigen::ArrayXXd& pressure);
}  // namespace wheel_rail_contact::core
