// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/track/rail_along.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core
{
/// Rail of a side in the ideal track at the place x of the line [m]. For pictures: RailAlong is faster where the
/// profile changes. Side axes.
PlacedRail restingRail(const ContactModelConfig& config, Side side, double x = 0);

/// Coordinates of the deflection of a rail head, side axes. They are lateral outward [m],
/// vertical up [m] and outward roll about the reference point of the head [rad]. The forces along them are the outward
/// force on the rail [N], the upward force on the rail [N] and the moment on the head about that point [N m].
Eigen::Vector3d toCoordinates(const RailDeflection& deflection);
/// Deflection with these coordinates.
RailDeflection toDeflection(const Eigen::Vector3d& coordinates);

/// Compliance along the coordinates, from the table of the upright rail, for a rail inclined by `inclination` [rad].
Eigen::Matrix3d supportCompliance(const ComplianceTable& table, double inclination);

/// A rail on its supports: its place in the track, a given displacement, and the deflection by forces. Side axes; the
/// forces and displacements are along the coordinates above.
class SupportedRail
{
 public:
  /// Keeps references to the sections of the rail, if it has any.
  SupportedRail(const ContactModelConfig& config, Side side);

  /// Moves along the line to x [m], which the sections of the rail contain. @return true if the profile or its place in
  /// the ideal track is another one than before
  bool moveTo(double x) { return along_.moveTo(x); }
  /// Sets the displacement besides the prescribed one and that by forces.
  void displace(const RailDeflection& displacement);

  /// Sets its course along the track.
  void setCourse(const RailCourse& course) { course_ = course; }
  const RailCourse& course() const { return course_; }

  /// Sets constant forces on it, besides those of under().
  void bear(const Eigen::Vector3d& forces);

  /// Rail in the ideal track.
  const PlacedRail& atRest() const { return along_.rail(); }
  /// Length of the longest profile, over all places [m].
  double longest() const { return along_.longest(); }
  /// See displace().
  const RailDeflection& displacement() const { return displacement_; }
  /// True if forces deflect it.
  bool bends() const { return bends_; }
  /// Displacement per force; zero if it does not bend.
  const Eigen::Matrix3d& compliance() const { return compliance_; }
  /// Forces of bear().
  const Eigen::Vector3d& borne() const { return borne_; }
  /// The rail with these coordinates, on its course, below a wheel.
  PlacedRail placedAt(Eigen::Vector3d coordinates, const WheelRim& rim) const;
  /// Whole displacement under forces.
  Eigen::Vector3d under(const Eigen::Vector3d& forces) const { return offset_ + compliance_ * forces; }

 private:
  RailAlong along_;
  Eigen::Matrix3d compliance_ = Eigen::Matrix3d::Zero();
  bool bends_;
  Eigen::Vector3d prescribed_ = Eigen::Vector3d::Zero();
  RailDeflection displacement_;
  RailCourse course_;
  Eigen::Vector3d borne_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d offset_;  ///< all three together
};
}  // namespace wheel_rail_contact::core
