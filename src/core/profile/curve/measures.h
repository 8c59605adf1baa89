// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Distance of the running circle from the flange back, unless a file states another one (EN 13715) [m]. Depth below
/// the top of a rail at which the gauge is measured (EN 13848-1), and of the front of a flange below the running circle
/// (EN 15313) [m].
constexpr double running_circle_distance = 0.070, gauge_depth = 0.014, front_depth = 0.010;

/// Point of a profile, in the profile frame (y to the field side, z up) [m].
struct ProfilePlace
{
  double y, z;
};

/// Measures of a wheel [m], as defined in EN 15313. The running circle is the origin, at y = 0, 70 mm from the flange
/// back. A measure is empty if the profile does not reach its points.
struct WheelMeasures
{
  ProfilePlace running_circle;              ///< point of the tread at y = 0
  ProfilePlace flange_tip;                  ///< lowest point of the profile
  std::optional<ProfilePlace> front;        ///< point of the front of the flange, 10 mm below the running circle
  std::optional<ProfilePlace> flange_back;  ///< point of the flange back at the height of `front`
  std::optional<ProfilePlace> upper;        ///< point of the front of the flange, 2 mm above the flange tip
  double flange_height;                     ///< Sh: of the tip below the running circle
  std::optional<double> flange_thickness;   ///< Sd: distance of `front` from the flange back, along y
  std::optional<double> flange_gradient;    ///< qR: distance of `front` and `upper` along y
};

/// Measures of a rail, as it is stored in its file: upright, or inclined as it lies in the track. A measure is empty if
/// the profile does not reach its points. The gauge is measured 14 mm below the top (EN 13848-1).
struct RailMeasures
{
  ProfilePlace top;                         ///< highest point
  std::optional<ProfilePlace> gauge_point;  ///< point closest to the track centre, of those up to 14 mm below the top
  std::optional<ProfilePlace> gauge_side;   ///< point of the gauge side, 14 mm below the top
  std::optional<ProfilePlace> field_side;   ///< point of the field side, 14 mm below the top
  std::optional<double> head_width;         ///< distance of the two along y [m]
  /// Lean of the sides of the head [rad]: of the straight line nearest to the side from 17 mm to 26 mm below the top,
  /// from the vertical, positive if the side leans outward going up. Empty if the side ends less than 21 mm below the
  /// top, is more than 0.05 mm (r.m.s.) from a straight line, or points are missing there. 1:20 on an upright rail:
  /// +0.05 of the gauge side, -0.05 of the field side.
  std::optional<double> gauge_side_lean, field_side_lean;
  /// Lean of the axis of symmetry of the head down to 13 mm below the top, positive towards the track centre [rad].
  /// Empty if a side ends less than 8 mm below it, or the middles of the head are more than 0.05 mm (r.m.s.) from a
  /// straight line.
  std::optional<double> axis_lean;

  /// Inclination of the axis of the head towards the track centre [rad], from both sides if they have a lean, else from
  /// its symmetry. It is right if neither side is worn.
  std::optional<double> inclination() const;
};

/// Range of u of the running surface [m]. Wheel: from the flange tip to the end on the field side. Rail: down to 14 mm
/// below the top on both sides, or to the end.
ParameterRange runningSurface(const Profile& profile, ProfileKind kind);

/// @param profile  a wheel, as checked by readProfile()
WheelMeasures wheelMeasures(const Profile& profile);
/// @param profile  a rail, as checked by readProfile()
RailMeasures railMeasures(const Profile& profile);
}  // namespace wheel_rail_contact::core
