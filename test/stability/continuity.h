// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/wheelset_contact.h"

namespace wheel_rail_contact::stability
{
/// How an answer differs from that of a close neighbour.
struct Change
{
  bool jumped = false;    ///< a wheel has another number of patches, or one of them moved by more than `far`
  double pressure = 0;    ///< largest relative change of a wheel's highest pressure [-]
  double bounded_by = 0;  ///< bound() of that wheel [-]
};

/// Way of a patch beyond which it counts as another place of contact [m].
constexpr double far = 2.5e-4;

/// Bound of the relative change of a wheel's highest pressure between two answers `distance` [m] apart in y, without a
/// jump. Both may be off by their estimated errors. A contact's own approach changes by the bodies' relative way along
/// its normal; that is at most three times the lateral way (a flange at 70 degrees, pushed up beside a tread), and
/// pressure goes with the root of the approach (Hertz): half of 3 * distance / approach. A rail that bends by its table
/// adds as much again.
double bound(const PatchResult& before, const PatchResult& after, double distance);

Change changeBetween(const WheelsetResult& before, const WheelsetResult& after, double distance);
}  // namespace wheel_rail_contact::stability
