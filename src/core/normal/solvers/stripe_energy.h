// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Energy, up to a factor, of point forces on the smallest box of cells around `pressure` (in the order of the gap
/// arrays) whose sign changes from column to column. Negative: on cells so long the influence matrix is indefinite.
double stripeEnergy(const Grid& grid, const double* pressure);
}  // namespace wheel_rail_contact::core
