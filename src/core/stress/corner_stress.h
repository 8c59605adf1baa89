// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/stress.h"

namespace wheel_rail_contact::core
{
/// Stress below one corner of a quadrant of unit pressure, as a function of the offset from the corner [-].
///
/// The stress by a unit pressure on the rectangle x1 < x < x2, y1 < y < y2 is the sum over its corners, with the signs
/// of a double difference:
///
///     f(X - x1, Y - y1) - f(X - x2, Y - y1) - f(X - x1, Y - y2) + f(X - x2, Y - y2)
///
/// The functions are the second derivatives of Boussinesq's potentials V (Newtonian) and chi (logarithmic) over a
/// rectangle (Love 1929, sec. 3 and 5; Johnson 1985, eq. 3.1 to 3.3):
///
///     2 pi xx = 2 nu V_z - (1 - 2 nu) chi_xx - z V_xx,   2 pi zz = V_z - z V_zz,   2 pi xz = -z V_xz,
///     2 pi xy = -(1 - 2 nu) chi_xy - z V_xy
///
/// @param x, y  offset of the point from the corner [m]
/// @param z     depth [m], >= 0; not all three may be zero
Stress cornerStress(double x, double y, double z, double poisson);
}  // namespace wheel_rail_contact::core
