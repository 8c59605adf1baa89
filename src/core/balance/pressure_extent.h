// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Where in its grid a pressure lies. Edges are where the square of the crest's pressure, carried on from the two
/// outermost loaded cells, falls to zero (it is linear in the distance from the edge of any smooth contact).
struct PressureExtent
{
  int cells = 0;                           ///< with pressure, in the whole grid
  int first_column = 0, last_column = -1;  ///< with pressure
  int first_row = 0, last_row = -1;        ///< with pressure
  double y_begin = 0, y_end = 0;           ///< edges across, patch frame [m]
  double half_length = 0;                  ///< largest |x| of the edges along [m]

  /// No cell carries pressure.
  bool empty() const { return cells == 0; }
  /// A spike between the cells: too few of them carry the pressure to tell where its edges are.
  bool spike() const { return cells > 0 && cells < 3; }
  /// An edge lies outside the grid: it cuts the contact off.
  bool cutBegin(const Grid& grid) const { return y_begin < grid.y(0) - 0.5 * grid.dy; }
  /// Likewise at the other end across.
  bool cutEnd(const Grid& grid) const { return y_end > grid.y(grid.ny - 1) + 0.5 * grid.dy; }
  /// Likewise along.
  bool cutLength(const Grid& grid) const { return half_length > 0.5 * grid.nx * grid.dx; }
  /// Any of them.
  bool cut(const Grid& grid) const { return cutBegin(grid) || cutEnd(grid) || cutLength(grid); }
};

/// The extent of a pressure [Pa] on its grid's stored cells.
PressureExtent findExtent(const Grid& grid, const Eigen::ArrayXXd& pressure);
}  // namespace wheel_rail_contact::core
