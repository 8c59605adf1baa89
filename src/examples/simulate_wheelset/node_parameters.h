// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace simulate_wheelset
{
/// Checks that the load of the dynamics (WheelsetDynamics::request()) is the one that a contact node expects. It is for
/// wheelset/balance: wheel_loads and wheelset/free: [z, roll], the defaults.
/// @param node name of the contact node
/// @throw std::runtime_error if the node has other values on the parameter server.
void requireWheelLoads(const std::string& node);

/// Nominal rolling radius of a contact node, the mean of both wheels [m]: wheelset/rolling_radius, or those of the
/// wheels (wheel/left/rolling_radius), or the default if the parameter server has none.
/// @param node name of the contact node
/// @throw std::runtime_error if a radius is not a number > 0.
double rollingRadiusOf(const std::string& node);
}  // namespace simulate_wheelset
