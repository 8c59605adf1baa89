// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact
{
/// A pressure field for drawing, resampled with more points than cells and with a smooth edge.
///
/// Near the edge of a contact the squared pressure falls linearly (Hertz; Johnson 1985, ch. 4.2). The squared pressure
/// is therefore extrapolated linearly into the cells beside the edge and interpolated bilinearly between the cell
/// centres. The contact is the region in which it is positive. At the cell centres the pressure is unchanged.
class PressureSurface
{
 public:
  /// @param pressure nx × ny [Pa]
  /// @param points minimum number of points in each direction; the cells are divided accordingly
  PressureSurface(const core::PatchGrid& grid, const Eigen::ArrayXXd& pressure, int points);

  /// Number of points along the track.
  int rows() const { return static_cast<int>(square_.rows()); }
  /// Number of points across the track.
  int columns() const { return static_cast<int>(square_.cols()); }
  /// x of a row of points, patch frame [m].
  double x(int row) const { return x0_ + row * dx_; }
  /// y of a column of points, patch frame [m].
  double y(int column) const { return y0_ + column * dy_; }
  /// Pressure at a point [Pa], >= 0.
  double pressure(int row, int column) const;

  /// Point of the surface.
  struct Point
  {
    double x, y;      ///< patch frame [m]
    double pressure;  ///< [Pa]
  };
  /// Triangles that cover the contact, three points each. Each rectangle of points is divided into two triangles, and
  /// these are cut at the edge of the contact, where the extrapolated squared pressure is zero.
  std::vector<Point> triangles() const;
  /// Edge of the contact: line segments of two points each, in no particular order.
  std::vector<Point> outline() const;

 private:
  struct Corner
  {
    double x, y;    ///< [m]
    double square;  ///< squared pressure [Pa²]; negative outside the contact
  };
  using Triangle = std::array<Corner, 3>;
  /// Point between two corners at which the squared pressure is zero. One of the corners must be loaded.
  static Point crossing(const Corner& from, const Corner& to);
  Corner cornerAt(int row, int column) const;
  std::vector<Triangle> allTriangles() const;

  double x0_, y0_, dx_, dy_;  ///< first point and spacings [m]
  Eigen::ArrayXXd square_;  ///< squared pressure [Pa²]; not positive outside the contact, nor at the outermost points
};
}  // namespace wheel_rail_contact
