// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
constexpr std::array<Side, 2> sides{Side::left, Side::right};

/// Index of a side in arrays of both sides.
constexpr std::size_t index(Side side)
{
  return static_cast<std::size_t>(side);
}
}  // namespace wheel_rail_contact::core
