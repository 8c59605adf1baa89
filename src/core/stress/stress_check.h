// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// @throw std::invalid_argument unless the pressure has the shape of the grid, the cells have a positive size, and
/// Poisson's ratio is in (-1, 0.5].
void requireStressInput(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson);

/// @throw std::invalid_argument unless the depth [m] is finite and at least 0.
void requireDepth(double depth);
}  // namespace wheel_rail_contact::core
