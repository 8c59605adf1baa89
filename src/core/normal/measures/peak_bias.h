// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/normal/measures/cells_around.h"
#include "core/normal/measures/edge_bias.h"
#include "core/normal/measures/gap_steps.h"
#include "core/normal/measures/relu_network.h"

namespace wheel_rail_contact::core
{
constexpr int peak_reach = 4;       ///< columns considered on either side of a peak
constexpr double largest_step = 2;  ///< limit of the GapSteps
constexpr int peak_inputs = 19;     ///< inputs for each side

/// Inputs of the networks at a peak.
struct PeakInputs
{
  using Side = Eigen::Array<float, peak_inputs, 1>;

  std::array<EdgeInputs, 2> tips;  ///< at the edge crossings that end the line along the track through the peak
  /// The row of the peak, seen from its first and from its last column (with opposite sign of the steps). The inputs
  /// are:
  /// * deficits of the pressures of peak_reach columns before and after the peak, relative to the peak (at least zero);
  /// * GapSteps between these columns;
  /// * deficit of the mean of the cells before and after the peak along the track, and half of their difference;
  /// * root of the sum of the squared steps.
  std::array<Side, 2> sides;
  double along = 0;  ///< bend of the pressure along the track

  /// @param longer  logarithm of the cell length along x over the cell width
  PeakInputs(const CellsAround& peak, const GapSteps& steps, double longer);
};

/// True if the bias can be computed: the peak has loaded cells on both sides across the track, the curvature of the gap
/// does not jump up and down near it, and the border of the grid does not cut the pressure along the track.
bool showsBias(const CellsAround& peak, const GapSteps& steps);

/// Bias of the parabola maximum at a pressure peak. Two one-hidden-layer ReLU networks.
struct PeakBias
{
  static constexpr int tip_units = 8, side_units = 16;
  using Tip = ReluNetwork<edge_inputs, tip_units>;
  using Side = ReluNetwork<peak_inputs, side_units>;
  static constexpr int numbers = Tip::numbers + Side::numbers;

  Tip tip;    ///< for each tip, over the bend along the track
  Side side;  ///< for the row, evaluated from each side

  /// Bias over the true pressure [-].
  double of(const PeakInputs& inputs) const;
};

/// Weights in use. Fitted by test/calibration/fit_peak_bias.cpp in revision e6707df.
const PeakBias& peakBias();
}  // namespace wheel_rail_contact::core
