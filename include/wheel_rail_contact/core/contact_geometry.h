// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
/// Positions of the wheelset for which the contact geometry is computed.
struct ContactGeometryOptions
{
  double y_first = -0.010;  ///< first lateral displacement of the axle centre, to the left positive [m], |y| <= 0.1
  double y_last = 0.010;    ///< last one [m], above y_first
  double y_step = 1e-4;     ///< their distance [m], > 0; at most 20000 steps
  /// True: height and roll follow from touch on both sides. False: each wheel touches at its own height without roll,
  /// as in the reference results of EN 15302:2008+A1:2010, annex E.
  bool roll = true;
  double distance = 0;  ///< place on the line, for rails with sections: see WheelsetState::distance [m]
};

/// Point at which a rigid wheel touches its rail.
struct TouchPoint
{
  double y = 0;        ///< track frame, to the left positive [m]
  double z = 0;        ///< track frame, up positive [m]
  double wheel_y = 0;  ///< position on the wheel profile, from the running circle to the field side [m]
  double rail_y = 0;   ///< position on the upright rail profile, from its origin to the field side [m]
  double angle = 0;    ///< of the common tangent to the track plane, positive if it rises to the field side [rad]
  double radius = 0;   ///< rolling radius: of the wheel, measured from the axle, at this point [m]
};

/// Result of one position, or the reason why there is none.
enum class GeometryStatus
{
  ok,           ///< both wheels touch their rails
  beside_rail,  ///< a wheel is beside its rail
  off_profile,  ///< a wheel touches its rail at the end of a profile
  no_roll,      ///< no roll up to 0.2 rad brings both wheels into touch
  /// A touch lies where points of a profile file are missing (ShapeError::missing): the shape is not known there.
  points_missing
};

/// "ok", "beside_rail", "off_profile", "no_roll" or "points_missing".
const char* toString(GeometryStatus status);

/// Contact geometry at one lateral displacement, without yaw. Rigid bodies.
struct GeometryPoint
{
  double y = 0;     ///< lateral displacement of the axle centre, to the left positive [m]
  double z = 0;     ///< height of the axle centre [m]; without roll the mean of those at which each wheel touches
  double roll = 0;  ///< rotation about x, positive if the left wheel is raised [rad]
  Sides<TouchPoint> touch;                     ///< of each wheel; valid if `status` is ok, as are z and roll
  GeometryStatus status = GeometryStatus::ok;  ///< whether there is a result

  /// Rolling radius difference, left minus right [m]. It grows with y if the wheelset is guided to the centre.
  ///
  /// EN 15302 takes the right wheel minus the left one over a displacement to the right. Its curve is this one turned
  /// by 180° about the origin, and thus the same curve if both sides are mirror images.
  double radiusDifference() const { return touch.left.radius - touch.right.radius; }
};

/// Point of the rolling radius difference as a function of the lateral displacement. Signs as in GeometryPoint.
struct RadiusDifference
{
  double y = 0;      ///< lateral displacement [m]
  double value = 0;  ///< rolling radius difference, left minus right [m]
};

/// Contact geometry over the lateral displacement.
struct ContactGeometry
{
  std::vector<GeometryPoint> points;  ///< at the positions of the options
  /// Rolling radius difference over the longest uninterrupted range of positions with a result, y increasing: the
  /// points above, and further ones, until straight lines between them are accurate to 0.2 um. A jump has a point on
  /// both sides, at most 0.1 um apart.
  std::vector<RadiusDifference> curve;
};

/// Computes the contact geometry of a wheelset in the ideal track: rigid rails without deflection, no irregularities,
/// no yaw.
/// @throw std::invalid_argument with the name of the parameter or option, its value and the broken rule: if a parameter
/// or an option is out of range, or a rail has several parts at this place, or no section there.
ContactGeometry contactGeometry(const ContactModelConfig& config, const ContactGeometryOptions& options = {});
}  // namespace wheel_rail_contact::core
