// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/balance/grid_levels.h"
#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core::paper
{
/// Result of a method for a case on one grid.
struct MethodRow
{
  std::string method;  ///< name as in contact/method
  GridSize size;
  double cell_along, cell_across;  ///< [m]
  double stop;          ///< change (seidel_printed) or residual (other methods) at which the method stops [-]
  int iterations;       ///< sweeps, or products with the influence matrix, of the last solution
  Figures figures;      ///< zero if there is no solution
  double counted_area;  ///< area of all cells with pressure [m²]
};

/// Solves one wheel at the position of the case, on a rail with a given deflection of its reference point. Rows:
/// - accurate solution (first row);
/// - repaired Seidel iteration;
/// - printed Seidel iteration on nearly square cells (within a few per cent) of several sizes, with an early and a late
///   stop.
///
/// @throw std::runtime_error if the accurate solution fails
std::vector<MethodRow> compareMethods(const ContactModelConfig& config, const RailDeflection& deflection);
}  // namespace wheel_rail_contact::core::paper
