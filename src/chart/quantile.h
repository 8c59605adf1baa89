// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace wheel_rail_contact::core::chart
{
/// Quantile of the values, without interpolation.
/// @param share  0 to 1
/// @return NaN if there are no values
double quantile(std::vector<double> values, double share);
}  // namespace wheel_rail_contact::core::chart
