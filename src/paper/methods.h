// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/balance/wheel_patch.h"
#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core::paper
{
/// What a method makes of a case on one grid.
struct MethodRow
{
  std::string method;  ///< name as in contact/method
  GridSize size;
  double cell_along, cell_across;  ///< [m]
  double stop;                     ///< change (seidel_printed) or residual (the others) at which the method stops [-]
  int iterations;                  ///< of the last solution: sweeps, or products with the influence matrix
  Figures figures;                 ///< zero where there is no solution
  double counted_area;             ///< of all cells with pressure [m²]
};

/// Solves one wheel at the case's position on a rail deflected by `deflection` (of its reference point): accurately
/// (the first row), by the repaired Seidel iteration, and by the printed one on square cells (to a few per cent) of
/// several sizes, stopped early and late.
/// @throw std::runtime_error if the accurate solution fails: the squares are cut after it.
std::vector<MethodRow> compareMethods(const ContactModelConfig& config, const RailDeflection& deflection);
}  // namespace wheel_rail_contact::core::paper
