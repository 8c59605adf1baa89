// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/track/contact_search.h"
#include "core/track/placement.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Plane in which a patch is solved, in side axes; turned about x only.
struct ContactPlane
{
  double x = 0, y = 0, z = 0;  ///< origin, on the rail [m]
  double angle = 0;            ///< about x [rad]; its tangent is (cos, sin) in the y-z plane, its normal (-sin, cos)
  double wheel_u = 0;          ///< parameter of the wheel's profile at the origin [m]
  double rail_u = 0;           ///< parameter of the rail's profile at the origin [m]
};

/// The plane through the rail's point of an initial contact, tangent to both bodies.
ContactPlane tangentPlane(const PlacedWheel& wheel, const PlacedRail& rail, const InitialContact& contact);

/// Tangent and normal of a plane in the y-z plane, ready for many points.
class PlaneAxes
{
 public:
  /// Keeps no reference to the plane.
  explicit PlaneAxes(const ContactPlane& plane);
  /// Place of a point along the plane [m].
  double t(double y, double z) const { return cosine_ * (y - y_) + sine_ * (z - z_); }
  /// Likewise.
  double t(const PlanePoint& p) const { return t(p.y, p.z); }
  /// Height of a point over the plane [m].
  double n(const PlanePoint& p) const { return cosine_ * (p.z - z_) - sine_ * (p.y - y_); }
  /// y and z of the place t along and n over the plane [m].
  double y(double t, double n) const { return y_ + cosine_ * t - sine_ * n; }
  /// Likewise.
  double z(double t, double n) const { return z_ + sine_ * t + cosine_ * n; }
  /// Of the plane's angle.
  double cosine() const { return cosine_; }
  /// Likewise.
  double sine() const { return sine_; }
  /// Derivatives of t and n with respect to the profile's parameter [-].
  double dt(const PlanePoint& p) const { return cosine_ * p.dy + sine_ * p.dz; }
  /// Likewise.
  double dn(const PlanePoint& p) const { return cosine_ * p.dz - sine_ * p.dy; }

 private:
  double y_, z_, cosine_, sine_;
};

/// What a column of a gap (constant y in the patch frame) knows of the bodies at x = 0.
struct GapColumn
{
  double slope = 0;        ///< mean slope of wheel and rail against the plane [-]: that of their common normal
  double wheel_u = 0;      ///< parameter of the wheel's profile [m]
  double rail_u = 0;       ///< parameter of the rail's profile [m]
  double parting = 0;      ///< slope of the wheel less that of the rail [-]: that of the gap across
  double rail_height = 0;  ///< of the rail over the plane [m]

  /// Slope of the rail against the plane [-].
  double railSlope() const { return slope - 0.5 * parting; }
  /// Likewise of the wheel.
  double wheelSlope() const { return slope + 0.5 * parting; }
};

constexpr double no_body_gap = 0.1;  ///< gap where one of the bodies has nothing to touch [m]

/// Gap between a placed wheel and a placed rail along a plane's normal, on a grid in that plane: fills `gap`
/// (grid.rows() × grid.ny) [m] and one entry of `columns` for each column; `no_body_gap` where one of the bodies has no
/// point over the plane.
///
/// The rail's height is found for each column on its profile; the wheel's at the crest and at two (without symmetry:
/// four) more places along the column, each on the surface of revolution itself (its profile told by the derivatives
/// under the crest, to 1e-11 m, where no joint is near), and a polynomial of degree four in x through them gives the
/// cells. Over a patch of half-length l on a wheel of radius R it is off by the order of
/// l (l/R)^5, less than 1e-8 m for l = 20 mm, where a column stays on one section of the profile. Yaw takes it over
/// l tan(yaw) of the profile; a joint there, at which the curvature jumps by k, makes it off by up to
/// k (l tan(yaw))²/2, measured a quarter of that at most: 5e-7 m where the flank's straight part meets the root's arc
/// of 13 mm, at 20 mrad and l = 10 mm. Without yaw the circles' own slant does so on the flank, 3e-7 m at l = 20 mm.
/// @return false if no column has both bodies.
bool buildGap(const PlacedWheel& wheel, const PlacedRail& rail, const ContactPlane& plane, const Grid& grid,
              Eigen::ArrayXXd& gap, std::vector<GapColumn>& columns);
}  // namespace wheel_rail_contact::core
