// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Steps of SecondDifference from one column to the next of no more are smooth.
constexpr double smooth_step = 0.01;

/// The gap's second differences across, times E* / dy over one of the contact's pressures [-]: where they step, the
/// gap's curvature jumps, and the pressure's slope per cell grows by the step times a logarithm.
class SecondDifference
{
 public:
  /// @param modulus  E* [Pa]
  /// @param over     [Pa]
  SecondDifference(const PatchGap& gap, double modulus, double over)
      : gap_(gap.gap), scale_(modulus / (gap.grid.dy * over))
  {
  }

  /// NaN at the grid's border and where a body ends.
  double at(Eigen::Index row, Eigen::Index column) const
  {
    constexpr double no_surface = 5;  // those of joints are below 3
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
