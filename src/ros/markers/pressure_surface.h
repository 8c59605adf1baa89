// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "wheel_rail_contact/core/wheelset_result.h"

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
  PressureSurface(const core::PatchGrid& grid, const Eigen::ArrayXXd& pressure, int points);

  /// Points along.
  int rows() const { return static_cast<int>(square_.rows()); }
  /// Points across.
  int columns() const { return static_cast<int>(square_.cols()); }
  /// Patch frame [m].
  double x(int row) const { return x0_ + row * dx_; }
  /// Patch frame [m].
  double y(int column) const { return y0_ + column * dy_; }
  /// [Pa], >= 0.
  double pressure(int row, int column) const;

  /// A point of the surface.
  struct Point
  {
    double x, y;      ///< patch frame [m]
    double pressure;  ///< [Pa]
  };
  /// The contact area in triangles, three points each. Every rectangle of points is cut in two triangles, and these at
  /// the contact's edge, where the continued square is zero.
  std::vector<Point> triangles() const;
  /// The edge in straight pieces, two points each, in no order.
  std::vector<Point> outline() const;

 private:
  struct Corner
  {
    double x, y;    ///< [m]
    double square;  ///< [Pa²]
  };
  using Triangle = std::array<Corner, 3>;
  /// Where the square is zero between two corners of which one is loaded.
  static Point crossing(const Corner& from, const Corner& to);
  Corner cornerAt(int row, int column) const;
  std::vector<Triangle> allTriangles() const;

  double x0_, y0_, dx_, dy_;  ///< first point and spacings [m]
  Eigen::ArrayXXd square_;    ///< of the pressure [Pa²]; not positive where there is none, as on the rim
};
}  // namespace wheel_rail_contact
