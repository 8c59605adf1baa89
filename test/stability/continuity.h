// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::stability
{
/// How an answer differs from that of a close neighbour.
struct Change
{
  bool jumped = false;    ///< a wheel has another number of patches, or one of them moved by more than `far`
  double pressure = 0;    ///< largest relative change of a wheel's highest pressure [-]
  double bounded_by = 0;  ///< what explains a change of that wheel without a jump [-]
};

/// Way of a patch beyond which it counts as another place of contact [m].
constexpr double far = 2.5e-4;

/// `distance`: between the two answers, in y [m]
Change changeBetween(const WheelsetResult& before, const WheelsetResult& after, double distance);
}  // namespace wheel_rail_contact::core::stability
