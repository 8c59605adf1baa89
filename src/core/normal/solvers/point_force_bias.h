// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/estimate/error_estimate.h"

namespace wheel_rail_contact::core
{
/// By how much forces at the cells' centres (Kernel::point_force) displace the highest cell of a pressure otherwise
/// than the pressure itself does [m], >= 0. `modulus`: contact modulus E* [Pa].
double pointForceBias(const PatchPressure& pressure, double modulus);

/// Errors that a solution with point forces has beyond those of its grid, in a patch with pressure.
///
/// Multiples of the bias over the approach, fitted once, by a program that is not kept, to 882 random contacts on grids
/// of 4 × 16 to 12 × 32 cells: together with the grid's, the largest estimate was at least the true error in 98 % of
/// them; normal/error_estimate_test.cpp asks for 95 % on others. They do not hold where cells are so long that the
/// matrix is indefinite (more than 4.70 times their width).
ErrorEstimate pointForceErrors(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch);
}  // namespace wheel_rail_contact::core
