// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace wheel_rail_contact::core::chart
{
/// What the share (0 to 1) of the values stays below, the nearest of them; not a number if there are none.
double quantile(std::vector<double> values, double share);
}  // namespace wheel_rail_contact::core::chart
