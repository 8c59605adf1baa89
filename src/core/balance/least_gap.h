// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Minimum of a gap [m], also between the cells: from parabolas along and across the track through the lowest cell and
/// its neighbours.
double leastGap(const Grid& grid, const Eigen::ArrayXXd& gap);
}  // namespace wheel_rail_contact::core
