// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/track/contact_search.h"
#include "core/track/placement.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Plane of a patch, in side axes. It is rotated about x only.
struct ContactPlane
{
  double x = 0, y = 0, z = 0;  ///< origin, on the rail [m]
  double angle = 0;            ///< about x [rad]; in the y-z plane the tangent is (cos, sin), the normal (-sin, cos)
  double wheel_u = 0;          ///< parameter of the wheel profile at the origin [m]
  double rail_u = 0;           ///< parameter of the rail profile at the origin [m]
};

/// Plane through the rail point of an initial contact, tangent to both bodies.
ContactPlane tangentPlane(const PlacedWheel& wheel, const PlacedRail& rail, const InitialContact& contact);

/// Axes of a contact plane in the y-z plane: t along the plane, n normal to it, both from its origin.
class PlaneAxes
{
 public:
  /// Keeps no reference to `plane`.
  explicit PlaneAxes(const ContactPlane& plane);
  /// t of a point in side axes [m].
  double t(double y, double z) const { return cosine_ * (y - y_) + sine_ * (z - z_); }
  /// t of a point in side axes [m].
  double t(const PlanePoint& p) const { return t(p.y, p.z); }
  /// n of a point in side axes: its height above the plane [m].
  double n(const PlanePoint& p) const { return cosine_ * (p.z - z_) - sine_ * (p.y - y_); }
  /// y in side axes of the point (t, n) [m].
  double y(double t, double n) const { return y_ + cosine_ * t - sine_ * n; }
  /// z in side axes of the point (t, n) [m].
  double z(double t, double n) const { return z_ + sine_ * t + cosine_ * n; }
  /// Cosine of the angle of the plane.
  double cosine() const { return cosine_; }
  /// Sine of the angle of the plane.
  double sine() const { return sine_; }
  /// Derivative of t with respect to the parameter of the profile [-].
  double dt(const PlanePoint& p) const { return cosine_ * p.dy + sine_ * p.dz; }
  /// Derivative of n with respect to the parameter of the profile [-].
  double dn(const PlanePoint& p) const { return cosine_ * p.dz - sine_ * p.dy; }

 private:
  double y_, z_, cosine_, sine_;
};

/// Sections of a wheel in the axes t and n of a plane.
WheelSections seenFrom(const PlaneAxes& axes, const WheelSections& wheel);

/// Both bodies at the middle (x = 0) of a column of a gap, that is, at constant y in the patch frame.
struct GapColumn
{
  double slope = 0;    ///< mean slope of wheel and rail relative to the plane [-]; slope of their common tangent plane
  double wheel_u = 0;  ///< parameter of the wheel profile [m]
  double rail_u = 0;   ///< parameter of the rail profile [m]
  double gap_slope = 0;    ///< slope of the gap across the track [-]: slope of the wheel minus slope of the rail
  double rail_height = 0;  ///< height of the rail above the plane [m]

  /// Slope of the rail relative to the plane [-].
  double railSlope() const { return slope - 0.5 * gap_slope; }
  /// Slope of the wheel relative to the plane [-].
  double wheelSlope() const { return slope + 0.5 * gap_slope; }
};

constexpr double no_body_gap = 0.1;  ///< gap in columns in which wheel or rail has no point [m]

/// Computes the gap between a placed wheel and a placed rail along the normal of a plane, on a grid in this plane.
///
/// The height of the rail is evaluated on its profile for each column. The height of the wheel is evaluated at the
/// middle of the column and at two more points along it (four on a grid without symmetry), each on the surface of
/// revolution itself. Away from discontinuities, its profile is replaced by the expansion about the middle of the
/// column (accurate to 1e-11 m). A polynomial of degree four in x through these points gives the cells.
///
/// Error of the polynomial, for a patch of half-length l on a wheel of radius R:
/// * Where a column stays on one section of the profile, the error is of the order of l (l/R)^5: less than 1e-8 m for
///   l = 20 mm.
/// * With yaw, a column extends over l tan(yaw) of the profile. A discontinuity at which the curvature jumps by k then
///   causes an error of up to k (l tan(yaw))²/2. The largest measured errors are a quarter of this: 5e-7 m where the
///   straight part of the flank meets the root arc of 13 mm, at 20 mrad and l = 10 mm.
/// * Without yaw, the wheel circles are inclined to the contact plane on the flank, with the same effect: 3e-7 m at
///   l = 20 mm.
/// @param gap      set to grid.rows() × grid.ny values [m]; `no_body_gap` in columns in which a body has no point
/// @param columns  set to one entry for each column
/// @return false if no column has points of both bodies.
bool buildGap(const PlacedWheel& wheel, const PlacedRail& rail, const ContactPlane& plane, const Grid& grid,
              Eigen::ArrayXXd& gap, std::vector<GapColumn>& columns);
}  // namespace wheel_rail_contact::core
