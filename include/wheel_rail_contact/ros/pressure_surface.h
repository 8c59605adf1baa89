// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// A pressure field resampled for drawing, finer than its cells and with a smooth edge.
///
/// Near the edge of a contact the pressure's square falls linearly (Hertz; Johnson 1985, ch. 4.2). So the square is
/// continued linearly into the cells beside the edge, interpolated bilinearly between cell centres, and its root taken
/// where it is positive. For pictures only: cell centres keep their values.
class PressureSurface
{
 public:
  /// @param pressure nx × ny [Pa] of a grid that is not symmetric
  /// @param points least number of points in either direction; cells are divided until there are so many
  PressureSurface(const Grid& grid, const Eigen::ArrayXXd& pressure, int points);

  int rows() const { return static_cast<int>(pressure_.rows()); }
  int columns() const { return static_cast<int>(pressure_.cols()); }
  double x(int row) const { return x0_ + row * dx_; }
  double y(int column) const { return y0_ + column * dy_; }
  double pressure(int row, int column) const { return pressure_(row, column); }

 private:
  double x0_, y0_, dx_, dy_;  ///< first point and spacings [m]
  Eigen::ArrayXXd pressure_;  ///< [Pa]; 0 on the rim
};
}  // namespace wheel_rail_contact
