// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "wheel_rail_contact/core/profile.h"
#include "wheel_rail_contact/core/rail_compliance.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Side axes, used for the calculation on either rail: x forward, y outward (to the field side), z up, origin in the
/// track frame's origin. They equal the track axes on the left and are their mirror image on the right, where y, roll
/// and yaw change sign; so both sides run through the same arithmetic and mirror symmetry is exact.
struct WheelsetPose
{
  double y = 0;     ///< axle centre [m]
  double z = 0;     ///< axle centre [m]
  double yaw = 0;   ///< about z [rad]
  double roll = 0;  ///< about x, before the yaw (fixed axes) [rad]
};

/// +1 on the left, -1 on the right.
double sideSign(Side side);

/// The pose seen from a side; its own inverse.
WheelsetPose toSide(Side side, const WheelsetPose& pose);

/// Point of a plane curve in side axes with its tangent.
struct PlanePoint
{
  double y, z;    ///< [m]
  double dy, dz;  ///< derivative with respect to the profile's parameter [-]
};

/// Where a rail's profile lies in any two coordinates (y and z, or others turned against them).
struct RailFrame
{
  double y = 0, z = 0;          ///< of the profile's origin [m]
  double cosine = 1, sine = 0;  ///< of the profile's angle against the coordinates

  /// Place and tangent of a point of the profile frame.
  PlanePoint at(const CurvePoint& p) const
  {
    return {y + cosine * p.y - sine * p.z, z + sine * p.y + cosine * p.z, cosine * p.dy - sine * p.dz,
            sine * p.dy + cosine * p.dz};
  }
};

/// A rail in side axes: its profile turned by the inclination, set to gauge, and displaced by the rail's deflection.
class PlacedRail
{
 public:
  /// Undeflected rail: highest point at z = 0, gauge measured `gauge_depth` below it.
  /// @throw std::invalid_argument if the profile does not reach down to the gauge depth on its gauge side.
  PlacedRail(std::shared_ptr<const Profile> profile, const TrackConfig& track);

  /// The same rail with its head displaced from the undeflected place.
  PlacedRail deflected(const RailDeflection& deflection) const;

  /// In its own frame.
  const Profile& profile() const { return *profile_; }
  /// The point at the profile's parameter u [m].
  PlanePoint at(double u) const;
  /// A point of the profile frame (on the profile or not) in side axes.
  PlanePoint place(const CurvePoint& point) const { return frame_.at(point); }
  /// All of that, in side axes.
  const RailFrame& frame() const { return frame_; }
  /// Angle of the rail's own axes against the side axes [rad]: the inclination less the outward roll.
  double angle() const;
  /// The head's reference point (ComplianceTable::reference_depth below the crown) [m].
  PlanePoint referencePoint() const;

 private:
  void turn(double angle);

  std::shared_ptr<const Profile> profile_;
  RailFrame frame_;
};

/// Point in side axes [m].
struct SpacePoint
{
  double x, y, z;  ///< forward, outward, up
};

/// Points of a wheel's profile, ready for PlacedWheel::loci().
struct WheelPoints
{
  static constexpr std::size_t together = 8;  ///< the number of points is a multiple of it

  std::vector<double> y;      ///< profile frame [m]
  std::vector<double> z;      ///< profile frame [m]
  std::vector<double> slope;  ///< CurvePoint::slope() [-]
};

/// A coordinate of a wheel's points as a linear function of where they lie in the wheel.
struct WheelCoordinate
{
  double origin = 0;   ///< of the axle's centre [m]
  double along = 0;    ///< for each metre along the axle, outward [-]
  double down = 0;     ///< for each metre from the axle, without x, down [-]
  double forward = 0;  ///< for each metre square to both, forward [-]
};

/// Point of a wheel's section at constant x with its tangent, or several of them.
template <typename Number>
struct SectionPoint
{
  Number down;    ///< from the axle [m]; not positive, or NaN, where x is beyond the point's circle
  Number y, z;    ///< [m]
  Number dy, dz;  ///< derivative with respect to the profile's parameter at constant x [-]
};

/// A wheel's sections square to the track in any two coordinates (y and z, or others that are linear in them).
struct WheelSections
{
  double radius = 0;         ///< of the running circle [m]
  double half_base = 0;      ///< from the axle's centre to the profile's origin [m]
  double axle_x = 0;         ///< of the axle's direction, outward [-]
  double per_forward_x = 1;  ///< 1 / that of the forward direction [-]
  WheelCoordinate y, z;      ///< the coordinates

  /// The lower point at `x` of the circle through a profile point: a CurvePoint, or several with their y, z, dy and dz
  /// as arrays.
  template <typename Number, typename Point>
  SectionPoint<Number> at(const Point& p, double x) const;
  /// The same of one point. @return false if x is beyond the circle.
  bool at(const CurvePoint& p, double x, PlanePoint& out) const;
};

/// A wheel in side axes: its profile as a surface of revolution about the wheelset's axle.
class PlacedWheel
{
 public:
  /// Refers to `profile`, which must outlive it.
  PlacedWheel(const Profile& profile, const WheelsetConfig& wheelset, const WheelsetPose& pose);

  /// Moves the axle's centre to another height, side axes [m].
  void setHeight(double z) { pose_.z = sections_.z.origin = z; }

  /// The contact locus: the point of the wheel's circle through profile point `p` at which the surface's normal has no
  /// component along x. The projection of the locus on the y-z plane is the wheel's outline seen along the track; since
  /// the rail is a prism along x, wheel and rail touch exactly where this outline touches the rail's profile.
  /// Closed form: with axle direction a and radial direction e, the normal e - (dr/ds) a has no x component.
  /// @return false where no such point exists (profile too steep for the yaw).
  bool locus(const CurvePoint& p, SpacePoint& out) const;
  /// y and z of the loci of points `first` to `behind`, both multiples of WheelPoints::together; NaN where there is
  /// none. `y` and `z` are as long as the points are many.
  void loci(const WheelPoints& points, std::size_t first, std::size_t behind, double* y, double* z) const;
  /// Where a profile's y lies on the axle, seen along the track [m]: a locus lies within sway() of it.
  double across(double y) const { return pose_.y + sections_.y.along * (sections_.half_base + y); }
  /// Bound of a locus's distance from across() [m].
  double lateralBound() const;

  /// The lower point at `x` of the wheel's circle through profile point `p`, with the derivative of y and z along the
  /// profile at constant x. @return false if x is beyond the circle.
  bool section(const CurvePoint& p, double x, PlanePoint& out) const { return sections_.at(p, x, out); }

  /// All sections, in side axes.
  const WheelSections& sections() const { return sections_; }

  /// In its own frame.
  const Profile& profile() const { return *profile_; }
  /// As given, but for the height (setHeight()); side axes.
  const WheelsetPose& pose() const { return pose_; }

 private:
  const Profile* profile_;
  WheelsetPose pose_;
  WheelSections sections_;
  double forward_x_;  ///< of the forward direction [-]
};

template <typename Number, typename Point>
SectionPoint<Number> WheelSections::at(const Point& p, double x) const
{
  using std::sqrt;
  const Number r = radius - p.z;
  const Number along = half_base + p.y;
  const Number forward = (x - axle_x * along) * per_forward_x;  // r sin(t)
  const Number down = sqrt(r * r - forward * forward);          // r cos(t)
  const Number forward_slope = -axle_x * per_forward_x * p.dy;
  const Number down_slope = (-r * p.dz - forward * forward_slope) / down;
  const auto coordinate = [&](const WheelCoordinate& c) -> Number
  { return c.origin + c.along * along + c.down * down + c.forward * forward; };
  const auto slope = [&](const WheelCoordinate& c) -> Number
  { return c.along * p.dy + c.down * down_slope + c.forward * forward_slope; };
  return {down, coordinate(y), coordinate(z), slope(y), slope(z)};
}
}  // namespace wheel_rail_contact::core
