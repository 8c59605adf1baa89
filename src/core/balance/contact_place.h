// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/track/placement.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
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
