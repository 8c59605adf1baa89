// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "wheel_rail_contact/core/profile.h"
#include "wheel_rail_contact/core/rail_compliance.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Pose of a wheelset in track axes or in side axes.
///
/// Side axes are used for the calculation on both rails: x forward, y outward (to the field side), z up; the origin is
/// that of the track frame. On the left they are the track axes. On the right they are the mirror image of the track
/// axes: y, roll and yaw change sign. Both sides use the same arithmetic. Mirror symmetry is therefore exact.
struct WheelsetPose
{
  double y = 0;     ///< y of the axle centre [m]
  double z = 0;     ///< z of the axle centre [m]
  double yaw = 0;   ///< rotation about z [rad]
  double roll = 0;  ///< rotation about x, before the yaw (fixed axes) [rad]
};

/// +1 on the left, -1 on the right.
double sideSign(Side side);

/// Converts a pose from track axes to side axes, or back: the function is its own inverse.
WheelsetPose toSide(Side side, const WheelsetPose& pose);

/// Point and tangent of a plane curve, in side axes unless stated otherwise.
struct PlanePoint
{
  double y, z;    ///< [m]
  double dy, dz;  ///< derivatives with respect to the parameter of the profile [-]
};

/// Position of a rail profile in two coordinates: y and z, or axes that are rotated relative to them.
struct RailFrame
{
  double y = 0, z = 0;          ///< origin of the profile [m]
  double cosine = 1, sine = 0;  ///< of the angle of the profile relative to the coordinates

  /// Converts a point and its tangent from the profile frame.
  PlanePoint at(const CurvePoint& p) const
  {
    return {y + cosine * p.y - sine * p.z, z + sine * p.y + cosine * p.z, cosine * p.dy - sine * p.dz,
            sine * p.dy + cosine * p.dz};
  }
};

/// Shape of a rail along the track, from its prism, to second order in x [m]: heights along the normal of its section,
/// or along the axis of a search.
struct AlongShape
{
  double slope = 0;      ///< at the place of the axle [-]
  double curvature = 0;  ///< second derivative; positive in a dip [1/m]

  double at(double x) const { return x * (slope + 0.5 * curvature * x); }
  double slopeAt(double x) const { return slope + curvature * x; }
};

/// Highest place of a shape along the track for a circle, and by how much it lifts the circle from the prism.
struct AlongTouch
{
  /// @param x0  place at which the circle touches the prism [m]
  AlongTouch(const AlongShape& shape, double x0, double circle_radius)
      : radius(1 / std::max(1 / circle_radius - shape.curvature, least_curvature)),
        x(x0 + radius * shape.slopeAt(x0)),
        lift(shape.at(x0) + 0.5 * radius * shape.slopeAt(x0) * shape.slopeAt(x0))
  {
  }

  double radius;  ///< of the circle relative to the shape [m]
  double x;       ///< [m]
  double lift;    ///< [m]

 private:
  static constexpr double least_curvature = 0.05;  ///< in a dip that is as round as the wheel [1/m]
};

/// Rim of a wheel that is not round about its lowest line, as its rail sees it: a larger radius is a higher rail.
struct WheelRim
{
  double rise = 0;     ///< of the radius over the rolling radius [m]
  AlongShape along;    ///< of the rim over a circle, as a height
  bool smooth = true;  ///< false: the second order fails, and the shape is a line at the lowest place of the wheel
};

/// Motion of the section of a rail along the track: derivatives of its displacement with respect to x.
struct RailMotion
{
  RailRates slope;  ///< first ones [-], [rad/m]
  RailRates bend;   ///< second ones [1/m], [rad/m²]

  bool operator==(const RailMotion& other) const
  {
    const auto equal = [](const RailRates& a, const RailRates& b)
    { return a.lateral == b.lateral && a.vertical == b.vertical && a.roll == b.roll; };
    return equal(slope, other.slope) && equal(bend, other.bend);
  }
};

/// Rail in side axes: its profile is turned by the inclination, moved to gauge and displaced by the deflection.
class PlacedRail
{
 public:
  /// Undeflected rail. Its highest point is at z = 0. Its innermost point down to z = -gauge_depth is at half the gauge
  /// from the track centre.
  /// @throw std::invalid_argument if the profile ends above the gauge depth on its gauge side.
  PlacedRail(std::shared_ptr<const Profile> profile, const TrackConfig& track, Side side);

  /// Rail with its profile at a given position.
  PlacedRail(std::shared_ptr<const Profile> profile, const RailFrame& frame)
      : profile_(std::move(profile)), frame_(frame)
  {
  }

  /// The same rail with its head displaced by `deflection` from its present position.
  PlacedRail deflected(const RailDeflection& deflection) const;

  /// Sets how it is displaced along the track, and the wheel on it.
  void setMotion(const RailMotion& motion, const WheelRim& rim = {})
  {
    motion_ = motion;
    rim_ = rim;
    changes_ = !(motion == RailMotion() && rim.along.slope == 0 && rim.along.curvature == 0);
  }
  const WheelRim& rim() const { return rim_; }
  /// True if it changes along the track, or the rim of the wheel does.
  bool changes() const { return changes_; }
  /// Shape along the track, along the normal, at the parameter u [m] of the profile, with that of the rim.
  AlongShape along(double u) const { return changes_ ? along(profile_->at(u)) : AlongShape(); }
  /// The same at a known point of the profile.
  AlongShape along(const CurvePoint& point) const { return along(point, rim_.along); }
  /// The same of the rail alone.
  AlongShape ownAlong(double u) const { return changes_ ? along(profile_->at(u), {}) : AlongShape(); }

  /// Profile of the rail, in the profile frame.
  const Profile& profile() const { return *profile_; }
  /// Point at the parameter u [m] of the profile, in side axes.
  PlanePoint at(double u) const { return place(profile_->at(u)); }
  /// Converts a point from the profile frame to side axes. The point need not be on the profile.
  PlanePoint place(const CurvePoint& point) const { return frame_.at(point); }
  /// Position of the profile in side axes.
  const RailFrame& frame() const { return frame_; }
  /// Angle of the rail relative to the side axes [rad]: inclination minus outward roll.
  double angle() const { return std::atan2(frame_.sine, frame_.cosine); }
  /// Reference point of the head, ComplianceTable::reference_depth below the crown [m].
  PlanePoint referencePoint() const { return place({0, -ComplianceTable::reference_depth, 1, 0, 0, 0}); }

 private:
  void turn(double angle);
  AlongShape along(const CurvePoint& point, const AlongShape& rim) const;

  std::shared_ptr<const Profile> profile_;
  RailFrame frame_;
  RailMotion motion_;
  WheelRim rim_;
  bool changes_ = false;
};

/// Point in side axes [m].
struct SpacePoint
{
  double x, y, z;  ///< forward, outward, up
};

/// Points of a wheel profile in the form that PlacedWheel::loci() requires.
struct WheelPoints
{
  static constexpr std::size_t together = 8;  ///< the number of points is a multiple of it

  std::vector<double> y;      ///< profile frame [m]
  std::vector<double> z;      ///< profile frame [m]
  std::vector<double> slope;  ///< CurvePoint::slope() [-]
};

/// One coordinate of the points of a wheel, as a linear function of their position in the wheel.
///
/// The position is given along three orthogonal directions: along the axle (outward), down (normal to the axle, without
/// x component) and forward (normal to both).
struct WheelCoordinate
{
  double origin = 0;   ///< coordinate of the axle centre [m]
  double along = 0;    ///< change per unit length along the axle [-]
  double down = 0;     ///< change per unit length down [-]
  double forward = 0;  ///< change per unit length forward [-]
};

/// Sections of a wheel at constant x, in two coordinates: y and z, or linear functions of them.
struct WheelSections
{
  double radius = 0;         ///< radius of the running circle [m]
  double half_base = 0;      ///< distance from the axle centre to the origin of the profile [m]
  double axle_x = 0;         ///< x component of the axle direction (outward) [-]
  double per_forward_x = 1;  ///< 1 / (x component of the forward direction) [-]
  WheelCoordinate y, z;      ///< both coordinates

  /// Lower point at `x` of the wheel circle through the profile point `p`, with the derivatives of both coordinates
  /// with respect to the parameter of the profile, at constant x. @return false if x is outside the circle.
  bool at(const CurvePoint& p, double x, PlanePoint& out) const
  {
    const double r = radius - p.z;
    const double along = half_base + p.y;
    const double forward = (x - axle_x * along) * per_forward_x;  // r sin(t)
    const double down = std::sqrt(r * r - forward * forward);     // r cos(t)
    const double forward_slope = -axle_x * per_forward_x * p.dy;
    const double down_slope = (-r * p.dz - forward * forward_slope) / down;
    const auto coordinate = [&](const WheelCoordinate& c)
    { return c.origin + c.along * along + c.down * down + c.forward * forward; };
    const auto slope = [&](const WheelCoordinate& c)
    { return c.along * p.dy + c.down * down_slope + c.forward * forward_slope; };
    out = {coordinate(y), coordinate(z), slope(y), slope(z)};
    return down > 0;
  }
};

/// Wheel in side axes: the surface of revolution of its profile about the axle.
class PlacedWheel
{
 public:
  /// Keeps a reference to `profile`, which must outlive the object.
  /// @param pose  pose of the wheelset in side axes
  /// @param rise  of the radius at the lowest line, over the rolling radius [m]
  PlacedWheel(const Profile& profile, const WheelsetConfig& wheelset, Side side, const WheelsetPose& pose,
              double rise = 0);

  /// Point of the contact locus on the wheel circle through the profile point `p`: the point at which the surface
  /// normal has no x component.
  ///
  /// Closed form: with the axle direction a and the radial direction e, the normal is e - (dr/ds) a. The projection of
  /// the locus along x is the outline of the wheel seen along the track. The rail is a prism along x. Wheel and rail
  /// therefore touch where this outline touches the rail profile.
  /// @return false if there is no such point (the profile is too steep for the yaw).
  bool locus(const CurvePoint& p, SpacePoint& out) const;
  /// x of this point [m].
  double locusX(const CurvePoint& p) const;
  /// y and z of the locus for the points `first` to `end` (exclusive); NaN where there is none. Both indices are
  /// multiples of WheelPoints::together. `y` and `z` have one element for each point.
  void loci(const WheelPoints& points, std::size_t first, std::size_t end, double* y, double* z) const;
  /// y in side axes of the point on the axle line that belongs to the profile coordinate `y` [m]. The point of the
  /// locus is within lateralBound() of it.
  double across(double y) const { return pose_.y + sections_.y.along * (sections_.half_base + y); }
  /// Upper bound of the lateral distance between a point of the locus and across() [m].
  double lateralBound() const;

  /// Lower point at `x` of the wheel circle through the profile point `p`, with the derivatives of y and z along the
  /// profile at constant x. @return false if x is outside the circle.
  bool section(const CurvePoint& p, double x, PlanePoint& out) const { return sections_.at(p, x, out); }

  /// Parameter of the profile whose point, in the section at x [m], lies on the normal of the rail at `origin` [m].
  /// Newton's method from `u`: a wheel turns little over the distance.
  double opposite(const PlanePoint& origin, double x, double u) const;

  /// Where the circle through a profile point touches a rail with this shape along its normal.
  /// @param x0  of the locus on this circle [m]
  AlongTouch touchAlong(const AlongShape& normal, const CurvePoint& p, double x0) const
  {
    // Along its normal, a cone is less curved than its circles (Meusnier's theorem).
    return {normal, x0, (sections_.radius - p.z) * std::hypot(p.dy, p.dz) / std::max(std::abs(p.dy), least_cosine)};
  }

  /// Sections of the wheel, in side axes.
  const WheelSections& sections() const { return sections_; }

  /// Profile of the wheel, in the profile frame.
  const Profile& profile() const { return *profile_; }
  /// Pose of the wheelset in side axes.
  const WheelsetPose& pose() const { return pose_; }

 private:
  static constexpr double least_cosine = 0.01;  ///< of a flank

  const Profile* profile_;
  WheelsetPose pose_;
  WheelSections sections_;
  double forward_x_;  ///< x component of the forward direction [-]
};

/// Largest overlap of the undeformed bodies along a normal of the rail [m], at most `reach` [m] from a place of both
/// profiles. Newton's method, or bisection, for the place at which the tangents are parallel.
double overlapAlongNormal(const PlacedWheel& wheel, const PlacedRail& rail, double wheel_u, double rail_u,
                          double reach);
}  // namespace wheel_rail_contact::core
