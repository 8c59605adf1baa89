// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Distance of the running circle from the flange back, unless a file states another one (EN 13715) [m]. Depth below
/// the top of a rail at which the gauge is measured (EN 13848-1) [m].
constexpr double running_circle_distance = 0.070, gauge_depth = 0.014;
}  // namespace wheel_rail_contact::core
