// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include <wheel_rail_contact/WheelsetContact.h>
#include "core/track/placement.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
// Results of the core and messages. The core does not know the wheelset's place along the track: `x` [m] is added on
// the way to a message and taken off on the way back. Units, axes and signs are the same on both sides.

/// The constant of the message.
std::uint8_t toMessage(core::ContactStatus status);
/// NO_TRANSFORM, of which the core knows nothing, becomes invalid_input.
/// @throw std::invalid_argument for a number that is no status.
core::ContactStatus statusFromMessage(std::uint8_t status);
/// True if an answer of this status, a constant of the message, holds a result.
bool isUsable(std::uint8_t status);

/// Track axes. Wheels are bodies of revolution, so only the axle's direction (ax, ay, az) counts: roll = asin(az) and
/// yaw = atan2(-ax, ay), the fixed-axis roll and yaw of an orientation Rz(yaw) Rx(roll) Ry(any rotation about the
/// axle).
core::WheelsetPose toWheelsetPose(const Eigen::Isometry3d& pose);
/// Axle centre at x, orientation Rz(yaw) Rx(roll).
geometry_msgs::Pose toMessage(const core::WheelsetPose& pose, double x);

/// Patch frame, `x` further along.
geometry_msgs::Pose toMessage(const core::PatchPose& pose, double x);
/// And back.
core::PatchPose patchPoseFromMessage(const geometry_msgs::Pose& pose, double x);

/// @param pressure nx × ny [Pa], stored as float32
/// @throw std::invalid_argument if the pressure's shape is not the grid's, or the grid is symmetric.
PressureGrid toMessage(const core::PatchGrid& grid, const Eigen::ArrayXXd& pressure);
/// @throw std::invalid_argument unless the message holds nx * ny values, with an origin at the grid's middle along x.
void fromMessage(const PressureGrid& message, core::PatchGrid& grid, Eigen::ArrayXXd& pressure);

/// Field by field.
RailDeflection toMessage(const core::RailResult& rail);
/// And back.
core::RailResult fromMessage(const RailDeflection& message);

/// @param with_grid false leaves the message's grid empty
ContactPatch toMessage(const core::PatchResult& patch, double x, bool with_grid);
/// @throw std::invalid_argument for an unknown side or method, or a grid of wrong size.
core::PatchResult fromMessage(const ContactPatch& message, double x);

/// Fills everything but the header and the time.
WheelsetContact toMessage(const core::WheelsetResult& result, double x, bool with_grids);
/// @throw std::invalid_argument as for its parts.
core::WheelsetResult fromMessage(const WheelsetContact& message);
}  // namespace wheel_rail_contact
