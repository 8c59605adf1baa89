// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "core/normal/measures/cells_around.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
constexpr int steps_reach = 6;  ///< number of columns considered on either side of a peak

/// Steps of the SecondDifference of the gap, over the peak pressure, from column to column in the row of a peak. The
/// first one is between the columns -steps_reach and 1 - steps_reach from the peak. Zero where a cell carries no
/// pressure or the body ends.
using GapSteps = std::array<double, static_cast<std::size_t>(2 * steps_reach)>;

GapSteps gapSteps(const CellsAround& peak, const PatchGap& gap, double modulus);

/// True if the curvature jumps up and down within a few cells, as on rough profiles. Curvature discontinuities cannot
/// be identified in that case.
bool areWaves(const GapSteps& steps);

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
