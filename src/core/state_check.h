// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Reason why a state is rejected, apart from its place on the track; empty if it is valid.
std::string_view faultOf(const WheelsetState& state, bool height_and_roll_given);
}  // namespace wheel_rail_contact::core
