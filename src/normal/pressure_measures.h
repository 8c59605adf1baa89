// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// Fills force, max_pressure, area and touches_border of `patch` from its pressure.
void measure(const Grid& grid, PatchPressure& patch);
}  // namespace wheel_rail_contact
