// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Motion of a profile in its plane: first the rotation about the origin, then the shift.
struct ProfileMotion
{
  double rotation = 0;  ///< from y (field side) towards z (up) [rad]: positive if a rail leans to the track centre
  double y = 0;         ///< shift to the field side [m]
  double z = 0;         ///< shift up [m]
};

/// Distance of a profile from a standard profile that was moved onto it.
struct StandardFit
{
  std::string name;      ///< of the standard profile
  ProfileMotion motion;  ///< of the standard profile
  double rms = 0;        ///< root mean square of the distance across the curve [m]
  double largest = 0;    ///< largest distance, with its sign: positive if the profile lies above the standard [m]
  double y = 0;          ///< place of the largest distance on the profile [m]
  double share = 0;      ///< share of the running surface over which both were compared [-]
};

/// Moves a standard profile to where the root mean square of its distance from `profile` is smallest.
///
/// Compared is the running surface (runningSurface()) at points every 0.25 mm, without ranges of missing points, as far
/// as the standard reaches. The distance is taken across the standard. Least squares by the method of Gauss and Newton:
/// each step moves the points along the tangents at their nearest points (Chen and Medioni, Object modelling by
/// registration of multiple range images, Image and Vision Computing 10, 1992). Steps that make the distance larger are
/// shortened, and the rotation is determined after the shift.
/// @param standard  of the same kind
/// @param rotated   true: the standard is also rotated
/// @return share 0 and rms infinite if less than half of the running surface could be compared, or nothing of it is
/// known
StandardFit standardFit(const Profile& profile, ProfileKind kind, const Profile& standard, bool rotated);

/// The standard profile of this kind with the smallest root mean square distance. Rails are rotated, because they may
/// be stored as they lie in the track. Wheels are not: a rotation would turn one conicity into another.
StandardFit nearestStandard(const Profile& profile, ProfileKind kind);
}  // namespace wheel_rail_contact::core
