// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Grid of the pressure of a patch: nx × ny equal rectangular cells. The centre of cell (i, j) is at (x(i), y(j)): x
/// along the track and y along the arc of the rail's section, from the origin of the patch frame. On a curved section
/// the cells leave the tangent plane.
struct PatchGrid
{
  int nx = 0;     ///< number of cells along the track
  int ny = 0;     ///< number of cells across the track
  double dx = 0;  ///< length of a cell along the track [m]
  double dy = 0;  ///< width of a cell across the track [m]
  double x0 = 0;  ///< x of the centres of the first row [m]
  double y0 = 0;  ///< y of the centres of the first column [m]

  /// x of the centres of row `row` [m].
  double x(int row) const { return x0 + row * dx; }
  /// y of the centres of column `column` [m].
  double y(int column) const { return y0 + column * dy; }
  /// Area of one cell [m²].
  double cellArea() const { return dx * dy; }
};
}  // namespace wheel_rail_contact::core
