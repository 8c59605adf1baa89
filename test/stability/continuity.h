// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::stability
{
/// Difference between the results of two neighbouring states.
struct Change
{
  bool jumped = false;  ///< the number of patches of a wheel differs, or one of its patches moved by more than `far`
  double pressure = 0;  ///< relative change of the highest pressure of a wheel [-], for the wheel nearest to its bound
  double bound = 0;     ///< largest change of that wheel that is explained without a jump [-]
};

/// Displacement of a patch beyond which it is another place of contact [m].
constexpr double far = 2.5e-4;

/// @param distance  difference of the two states in y [m]
Change changeBetween(const WheelsetResult& before, const WheelsetResult& after, double distance);
}  // namespace wheel_rail_contact::core::stability
