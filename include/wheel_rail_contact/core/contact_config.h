// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Method and accuracy of the contact solution.
struct ContactConfig
{
  /// Default `automatic`: conjugate gradients on a grid for the tolerance, and on finer ones (at most three) while the
  /// estimated error of the wheel exceeds the tolerance.
  NormalMethod method = NormalMethod::automatic;
  /// Target relative error of highest pressure, area and approach [-], in (0, 1). It determines the grid and the
  /// residual at which the iteration stops.
  double tolerance = 0.01;
  /// Number of cells of a grid along the track: even, 4 to 256; 0: chosen from the tolerance (`automatic`: its first
  /// grid; other methods: for half the expected error). Set both numbers or neither. With both, every method uses this
  /// grid, and `automatic` is conjugate gradients on it.
  int cells_along = 0;
  int cells_across = 0;  ///< number of cells of a grid across the track; same rule as cells_along
  /// Also searches for other equilibria of each state, see WheelsetResult::near_branch. Takes about ten times as long.
  /// No effect if height and roll are given.
  bool check_branches = false;
};

/// Checks that every parameter is within its range.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const ContactConfig& contact);
}  // namespace wheel_rail_contact::core
