// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/estimate/error_estimate.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Errors of a solution with point forces in addition to those of its grid, in a patch with pressure.
///
/// They are multiples of the bias over the approach. The factors were fitted once, by a program that is not kept, to
/// 882 random contacts on grids of 4 × 16 to 12 × 32 cells. Together with the grid errors, the largest estimate was at
/// least the true error in 98 % of them. test/core/normal/error_estimate_test.cpp requires 95 % on other contacts. The
/// factors are not valid for cells so long that the matrix is indefinite (more than 4.70 times their width).
ErrorEstimate pointForceErrors(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch);

/// Energy, up to a factor, of point forces with alternating sign from column to column on the smallest box of cells
/// around `pressure` (in the order of the gap arrays). A negative value means that the influence matrix is indefinite,
/// because the cells are too long.
double stripeEnergy(const Grid& grid, const double* pressure);
}  // namespace wheel_rail_contact::core
