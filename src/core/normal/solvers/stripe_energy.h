// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Energy, up to a factor, of point forces with alternating sign from column to column on the smallest box of cells
/// around `pressure` (in the order of the gap arrays). A negative value means that the influence matrix is indefinite,
/// because the cells are too long.
double stripeEnergy(const Grid& grid, const double* pressure);
}  // namespace wheel_rail_contact::core
