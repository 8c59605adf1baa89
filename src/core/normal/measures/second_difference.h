// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Steps of SecondDifference from column to column up to this size are regarded as smooth.
constexpr double smooth_step = 0.01;

/// Second differences of the gap across the track, times E* / dy over a pressure of the contact [-]. Where they step,
/// the curvature of the gap jumps. The slope of the pressure per cell then increases by the step times a logarithm.
class SecondDifference
{
 public:
  /// @param modulus  E* [Pa]
  /// @param over     pressure that divides the differences [Pa]
  SecondDifference(const PatchGap& gap, double modulus, double over)
      : gap_(gap.gap), scale_(modulus / (gap.grid.dy * over))
  {
  }

  /// NaN at the border of the grid and where a body ends.
  double at(Eigen::Index row, Eigen::Index column) const
  {
    constexpr double no_surface = 5;  // at curvature discontinuities the values are below 3
    if (column < 1 || column + 1 >= gap_.cols())
    {
      return NAN;
    }
    const double here = scale_ * (gap_(row, column + 1) - 2 * gap_(row, column) + gap_(row, column - 1));
    return std::abs(here) < no_surface ? here : NAN;
  }

 private:
  const Eigen::ArrayXXd& gap_;
  double scale_;
};
}  // namespace wheel_rail_contact::core
