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
  double y = 0, z = 0;          ///< point of the rail, side axes [m]
  double cosine = 1, sine = 0;  ///< tangent of the rail in the y-z plane
  double rail_u = 0;            ///< parameter of the rail profile [m]
  double wheel_u = 0;           ///< parameter of the wheel profile at the point opposite the middle of the column [m]
  double wheel_slope = 0;       ///< slope of the wheel relative to the plane at this point, towards the field side [-]

  AlongShape along;    ///< of the rail, along its normal
  double overlap = 0;  ///< largest overlap in the column [m]; 0 without

  /// The same slope, as the mean over the expected pressure of the column; without overlap at the lowest place. The
  /// surface of the wheel tilts towards its ends [-].
  double mean_slope = 0;
  bool has_bodies = false;  ///< both bodies have a point on the normal

  /// Angle of the tangent of the rail about x [rad].
  double angle() const { return std::atan2(sine, cosine); }
  /// Sine of the angle from the tangent of the rail in another column to that in this one [-].
  double turnFrom(const SurfaceColumn& other) const { return sine * other.cosine - cosine * other.sine; }
  /// Change of the gap per unit displacement of the wheel outward (y) [-].
  double perOutward() const { return -sine - mean_slope * cosine; }
  /// Change of the gap per unit displacement of the wheel up (z) [-].
  double perUp() const { return cosine - mean_slope * sine; }
};

constexpr double no_body_gap = 0.1;  ///< gap in columns in which wheel or rail has no point [m]

/// Turn of the normals over a contact that is neglected [rad]. Its square halved is the error of a pressure's effect.
constexpr double plane_turn = 0.2;

/// Square of the ratio of a contact's semi-axis along the track to that of the overlap [-]; that across is the rest
/// to 1. Of a Hertzian contact: D / K if it is the longer axis, with the complete elliptic integrals K and D of its
/// aspect ratio, which is (ratio of the curvatures)^(2/pi) (Hamrock and Brewe 1983).
double contactShare(double overlap_length, double overlap_width);

/// Largest turn of the normal of wheel or rail over the columns `first` to `last`, halved [rad].
double halfSpaceRatio(const std::vector<SurfaceColumn>& columns, Eigen::Index first, Eigen::Index last);

/// Leaves columns out that a vertical displacement hardly opens, or closes: their overlap is 0.
void leaveOutWalls(std::vector<SurfaceColumn>& columns, PatchGap& patch);

/// Sets weight and normals. The reference is the column with the deepest overlap. The turn is zero where the normals
/// hardly turn.
void setNormals(const std::vector<SurfaceColumn>& columns, PatchGap& patch, ColumnNormals& normals);

/// Raises a gap by (g_xx dx² + g_yy dy²) / 48: half of what its mean over a cell exceeds its value at the centre.
/// Pressures that are constant in each cell and close the gap at the centres need an approach that is too small by so
/// much; doc/theory.md, "Bias of the approach", derives it.
void raiseByCells(PatchGap& patch);

/// Slope of the gap across the track at the middle of a column: on the normal of a rail that turns by k per unit of its
/// arc, a body at the height g moves past by 1 - k g.
double gapSlope(const std::vector<SurfaceColumn>& columns, const PatchGap& patch, Eigen::Index j);

/// Length of a profile between two parameters [m], negative if `to` is less than `from`.
double arcLength(const Profile& profile, double from, double to);

/// Computes the gap between a placed wheel and a placed rail on a grid on the surface of the rail.
///
/// The cells are uniform along x and along the arc of the rail's section. The gap of a cell is the distance of the
/// wheel, as a surface of revolution, along the normal of the rail. Each column has its own normal. The profile of
/// the wheel is evaluated for each cell; close to the middle of a column by its expansion there (ColumnHeights).
/// @param origin   x and arc length of the grid are measured from here
/// @param gap      set to grid.rows() × grid.ny values [m]; `no_body_gap` in columns in which a body has no
/// point on the normal
/// @param slope    set to the slopes of the wheel across the track relative to the planes of the columns, of the same
/// shape [-]
/// @param columns  set to one entry for each column
/// @return false if no column has points of both bodies.
bool buildSurfaceGap(const PlacedWheel& wheel, const PlacedRail& rail, const SurfaceOrigin& origin, const Grid& grid,
                     Eigen::ArrayXXd& gap, Eigen::ArrayXXd& slope, std::vector<SurfaceColumn>& columns);
}  // namespace wheel_rail_contact::core
