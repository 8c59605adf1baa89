// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180;  ///< [rad]
}  // namespace wheel_rail_contact::core
