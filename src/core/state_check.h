// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Reason why a state is rejected, apart from its place on the track; empty if it is valid.
std::string_view faultOf(const WheelsetState& state, bool height_and_roll_given);

/// Reason why a height [m] is rejected that is `depth` [m] below that of first touch.
std::string tooDeep(double height, double depth);
}  // namespace wheel_rail_contact::core
