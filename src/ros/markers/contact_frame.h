// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "core/track/placement.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// Frame of the contact of one wheel in the track frame, relative to x of the axle centre: the origin is the mean of
/// the patch origins, weighted by their normal forces. x is forward along the track, z along the sum of the normal
/// forces, out of the rail. With one patch it is the patch frame; with several it moves continuously as the load moves
/// from one to the other. None without contact.
std::optional<Eigen::Isometry3d> contactFrame(const core::WheelsetResult& result, core::Side side);

/// Frame at the reference point of a rail at rest, parallel to the track frame, at x = 0: a place for the view before
/// the first contact.
Eigen::Isometry3d railFrame(const core::PlacedRail& at_rest, core::Side side);
}  // namespace wheel_rail_contact
