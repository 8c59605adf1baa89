// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Highest pressure [Pa] over the yield stress in shear, yield / sqrt 3 (von Mises) [-]; 0 if the yield stress in
/// tension [Pa] is 0.
double loadFactor(double max_pressure, double yield);

/// Bound of the load factor for shakedown, see PatchStress::shakedown_limit [-]; 0 without stress.
/// @param orthogonal  highest |xz| [Pa]
/// @param von_mises   highest von Mises stress [Pa]
double shakedownLimit(double max_pressure, double orthogonal, double von_mises);
}  // namespace wheel_rail_contact::core
