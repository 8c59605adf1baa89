// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Reason why the values of a station are refused; empty if they are finite and not above 0.2 m or 0.2 rad.
std::string_view fault(const LineStation& station);
}  // namespace wheel_rail_contact::core
