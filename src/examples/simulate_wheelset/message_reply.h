// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <wheel_rail_contact/WheelsetContact.h>

#include <string>

#include "examples/simulate_wheelset/contact_source.h"

namespace simulate_wheelset
{
/// Stamp of a time since the start [ns]. Stamps begin at 1000 s: messages with a stamp of 0 are dropped, and the trial
/// states of TopicContact have stamps before the start.
ros::Time stampOf(std::int64_t time);

/// Pose of the axle in the track frame. Height and roll are zero: they are results.
geometry_msgs::PoseStamped poseMessage(const ContactRequest& request, const std::string& frame);

/// Load on the axle centre, in track axes.
geometry_msgs::WrenchStamped loadMessage(const ContactRequest& request, const std::string& frame);

/// The reply in a message of the contact node.
ContactReply replyOf(const wheel_rail_contact::WheelsetContact& message);
}  // namespace simulate_wheelset
