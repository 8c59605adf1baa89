// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
/// Pressure of all cells of a grid, in track axes: nx × ny. A symmetric grid stores only half of the cells. On the
/// right side the columns are in reverse order.
void wholePressure(Side side, const Grid& grid, const Eigen::ArrayXXd& stored, Eigen::ArrayXXd& whole);
}  // namespace wheel_rail_contact::core
