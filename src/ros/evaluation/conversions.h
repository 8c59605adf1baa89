// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include <wheel_rail_contact/WheelsetContact.h>
#include "core/track/placement.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
// Conversions between the types of the core and messages. Units, axes and signs are the same in both. `x` is the
// position of the axle centre along the track [m]. Patch poses of the core are relative to it: it is added for a
// message, and subtracted from one.

/// Status constant of the message.
std::uint8_t toMessage(core::ContactStatus status);
/// Status of the core. NO_TRANSFORM, which the core does not have, becomes invalid_input.
/// @throw std::invalid_argument for an unknown status.
core::ContactStatus statusFromMessage(std::uint8_t status);
/// True if a result with this status constant is usable: OK or LIFT_OFF.
bool isUsable(std::uint8_t status);

/// Wheelset pose from a pose in the track frame. Only the direction (ax, ay, az) of the axle matters: roll = asin(az),
/// yaw = atan2(-ax, ay). For the orientation Rz(yaw) Rx(roll) Ry(rotation about the axle) these are the fixed-axis
/// angles.
core::WheelsetPose toWheelsetPose(const Eigen::Isometry3d& pose);
/// Rotation about the axle in that orientation, positive as the wheelset rolls forward [rad].
double pitchOf(const Eigen::Isometry3d& pose, const core::WheelsetPose& wheelset);
/// True if a message has a pose. Without one, all its numbers are zero, also those of the quaternion.
bool hasPose(const geometry_msgs::Pose& pose);
geometry_msgs::Vector3 vectorMessage(const Eigen::Vector3d& v);
/// Rotation as a message.
geometry_msgs::Quaternion toMessage(const Eigen::Quaterniond& q);
/// Pose of the axle centre in the track frame, with the orientation Rz(yaw) Rx(roll).
geometry_msgs::Pose toMessage(const core::WheelsetPose& pose, double x);
/// Pose of a patch frame in the track frame.
geometry_msgs::Pose toMessage(const core::PatchPose& pose, double x);

/// Pressure grid as a message.
/// @param pressure nx × ny [Pa], stored as float32
/// @throw std::invalid_argument if the shape of the pressure differs from that of the grid.
PressureGrid toMessage(const core::PatchGrid& grid, const Eigen::ArrayXXd& pressure);
/// Grid and pressure of a message.
/// @throw std::invalid_argument unless the message has nx * ny values and the grid is symmetric about x = 0.
void fromMessage(const PressureGrid& message, core::PatchGrid& grid, Eigen::ArrayXXd& pressure);

/// Contact patch as a message.
/// @param with_grid false: the grid of the message is left empty
ContactPatch toMessage(const core::PatchResult& patch, double x, bool with_grid);
/// Contact patch from a message.
/// @throw std::invalid_argument for an unknown side or method, or a grid of the wrong size.
core::PatchResult fromMessage(const ContactPatch& message, double x);

/// Result as a message, without header and solve_time.
/// @param with_grids false: the grids of the patches are left empty
WheelsetContact toMessage(const core::WheelsetResult& result, double x, bool with_grids);
/// Result from a message. Its x stays 0.
/// @throw std::invalid_argument for an unknown status, side or method, or a grid of the wrong size.
core::WheelsetResult fromMessage(const WheelsetContact& message);
}  // namespace wheel_rail_contact
