// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <string>

#include "config/node_config.h"
#include "ros/evaluation/contact_evaluator.h"

namespace wheel_rail_contact
{
/// Name of the wheelset's frame: wheelset/frame, otherwise from the namespace of its topics.
std::string wheelsetFrame(const NodeConfig& config, const std::string& topics);

/// Name of the frame at the centre of pressure of a wheel. Its axes are those of the track.
std::string contactFrame(const std::string& wheelset_frame, core::Side side);

/// Transforms of an output that the parameters request: the track frame at its place (track/publish_track_frame), the
/// wheelset with the pitch of its pose (wheelset/publish_tf), and the centres of pressure (wheelset/publish_wrenches).
tf2_msgs::TFMessage framesOf(const ContactOutput& output, const NodeConfig& config, const std::string& wheelset_frame);

/// Wrench of a wheel of a usable or held result. Displays draw it at the origin of its frame, contactFrame().
geometry_msgs::WrenchStamped wrenchMessage(const ContactOutput& output, core::Side side,
                                           const std::string& wheelset_frame);
}  // namespace wheel_rail_contact
