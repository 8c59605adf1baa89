// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <wheel_rail_contact/WheelsetContact.h>

#include <string>

#include "examples/simulate_wheelset/contact_source.h"

namespace simulate_wheelset
{
/// Stamp of a time since the start [ns]. Stamps begin at 1000 s: 0 is no valid stamp.
ros::Time stampOf(std::int64_t time);

/// Pose of the axle in the track frame. Height and roll are zero: they are results.
geometry_msgs::PoseStamped poseMessage(const ContactRequest& request, const std::string& frame);

/// Load on the axle centre, in track axes.
geometry_msgs::WrenchStamped loadMessage(const ContactRequest& request, const std::string& frame);

/// The reply in a message of the contact node.
ContactReply replyOf(const wheel_rail_contact::WheelsetContact& message);

/// The load of the dynamics is that of wheelset/balance: wheel_loads, the default (see WheelsetDynamics::request()).
/// @param node name of the contact node
/// @throw std::runtime_error if the node has another value on the parameter server.
void refuseBalanceOfMoments(const std::string& node);
}  // namespace simulate_wheelset
