// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/balance/wheelset_balance.h"
#include "core/track/placement.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/sides.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Fills the result of an island of a wheel, in track axes, except its method.
void fillPatch(Side side, const WheelsetBalance& balance, std::size_t island, PatchResult& out);

/// Pressure of all cells of a grid, in track axes: nx × ny. A symmetric grid stores only half of the cells. On the
/// right side the columns are in reverse order.
void wholePressure(Side side, const Grid& grid, const Eigen::ArrayXXd& stored, Eigen::ArrayXXd& whole);

/// Bound of the relative error of maximum pressure and area due to the half-spaces [-]. It was calibrated on contacts
/// by finite elements, under the same force (doc/half_space.md). Where no contact was compared, it is 1: not known.
///
/// The constant part covers the finite size of the bodies. The displacement by a force on a curved surface differs from
/// that on a plane by terms of the order of distance over radius. They have opposite signs on a wheel and on a rail,
/// and cancel where both have the same radius, so the square remains.
/// @param half_space_ratio  PatchResult::half_space_ratio [rad]
/// @param is_turned         displacements are projected onto the normals of the columns (ColumnNormals::turn)
double modelError(double half_space_ratio, bool is_turned);

/// What the profiles leave open about a patch.
struct ShapeEffect
{
  double max_pressure = 0;  ///< relative standard deviation of the highest pressure [-]
  bool missing = false;     ///< points of a profile are missing where the pressure is; the relative error is then 1
};

/// Error of a patch by the noise of its profiles.
///
/// Let c be the standard deviation of the relative curvature across, p that of the position, and k the relative
/// curvature. A change of the curvature over the whole contact changes the pressure by c/(2 k) in plane contact
/// (Johnson 1985, eq. 4.45: p0 ~ sqrt(k) under the same load). A wave of amplitude d and length l presses with E* pi
/// d/l (Johnson 1985, eq. 13.2, with waves in contact all over). With d = sqrt(2) p and l = 2 pi sqrt(p/c), the wave
/// that has both deviations, this is E* sqrt(p c/2) at its peaks. The error is the lesser of the two: long waves act by
/// their curvature, short ones are flattened.
/// @param profile       of the wheel
/// @param island        patch of the wheel, see WheelsetBalance::islands()
/// @param max_pressure  highest pressure of the patch [Pa], > 0
ShapeEffect shapeEffect(Side side, const WheelsetBalance& balance, const Profile& profile, std::size_t island,
                        double max_pressure);

/// Where the centre of pressure of a patch lies on both profiles.
struct ProfilePlaces
{
  double wheel_u = 0;  ///< parameter of the wheel profile, approximately [m]
  double rail_u = 0;   ///< parameter of the rail profile [m]
};

/// Fills the members of a patch that follow from the place of its centre of pressure on wheel and rail: rolling radius,
/// places on both profiles and around the wheel, and curvatures.
///
/// The curvature along x is that of the circle of the wheel through the contact, times the cosine of the angle between
/// the normal and the radius (Meusnier's theorem); the yaw of the axle is neglected.
/// @param axle   pose of the wheelset, track axes
/// @param patch  its side and pose are set
void placeOnBodies(const ContactModelConfig& config, const WheelsetPose& axle, const PlacedRail& rail,
                   const ProfilePlaces& places, PatchResult& patch);
}  // namespace wheel_rail_contact::core
