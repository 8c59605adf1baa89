// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "core/track/placement.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Origin of a grid on the surface of a rail. Side axes.
struct SurfaceOrigin
{
  double x = 0;        ///< [m]
  double rail_u = 0;   ///< parameter of the rail profile [m]
  double wheel_u = 0;  ///< parameter of the wheel profile opposite it, approximately [m]
};

/// Column of a grid on the surface of a rail: a line along the track. Its plane contains this line and is tangent to
/// the rail.
struct SurfaceColumn
{
  double y = 0, z = 0;     ///< point of the rail, side axes [m]
  double angle = 0;        ///< of the tangent of the rail in the y-z plane: dy = cos, dz = sin [rad]
  double rail_u = 0;       ///< parameter of the rail profile [m]
  double wheel_u = 0;      ///< parameter of the wheel profile at the point opposite the middle of the column [m]
  double wheel_slope = 0;  ///< slope of the wheel relative to the plane at this point, towards the field side [-]

  /// Change of the gap per unit displacement of the wheel outward (y) [-].
  double perOutward() const { return -std::sin(angle) - wheel_slope * std::cos(angle); }
  /// Change of the gap per unit displacement of the wheel up (z) [-].
  double perUp() const { return std::cos(angle) - wheel_slope * std::sin(angle); }
};

/// Length of a profile between two parameters [m], negative if `to` is less than `from`.
double arcLength(const Profile& profile, double from, double to);

/// Computes the gap between a placed wheel and a placed rail on a grid on the surface of the rail.
///
/// The cells are uniform along x and along the arc of the rail's section. The gap of a cell is the distance of the
/// wheel, as a surface of revolution, along the normal of the rail. Each column has its own normal. Along a column, the
/// gap is a polynomial of degree four in x (ColumnHeights); gap.h gives its errors.
/// @param origin   x and arc length of the grid are measured from here
/// @param gap      set to grid.rows() × grid.ny values [m]; `no_body_gap` (gap.h) in columns in which a body has no
/// point on the normal
/// @param columns  set to one entry for each column
/// @return false if no column has points of both bodies.
bool buildSurfaceGap(const PlacedWheel& wheel, const PlacedRail& rail, const SurfaceOrigin& origin, const Grid& grid,
                     Eigen::ArrayXXd& gap, std::vector<SurfaceColumn>& columns);
}  // namespace wheel_rail_contact::core
