// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/balance/wheelset_balance.h"

namespace wheel_rail_contact::core
{
/// Fills the result of an island of a wheel, in track axes, except its method.
void fillPatch(Side side, const WheelsetBalance& balance, std::size_t island, PatchResult& out);
}  // namespace wheel_rail_contact::core
