// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace wheel_rail_contact::core
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180;  ///< [rad]
}  // namespace wheel_rail_contact::core
