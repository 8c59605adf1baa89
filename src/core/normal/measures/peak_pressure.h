// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/normal/measures/cells_around.h"
#include "core/normal/measures/edge_bias.h"
#include "core/normal/measures/gap_steps.h"

namespace wheel_rail_contact::core
{
/// Peak pressure, between the cells if necessary [Pa]. If a neighbouring cell across the track is not loaded, it is the
/// pressure of the peak cell. The pressure must solve `gap` on its grid, with E* = `modulus` [Pa].
///
/// The value is the maximum of the parabolas through the squared pressures of the peak cell and its neighbours, minus
/// its known bias (PeakBias). The bias has two sources:
/// * Constant-pressure cells that satisfy the contact condition at their centres overestimate a peak. The error
///   increases with the bend of the pressure and depends on the position of the edge between the cells.
/// * At a jump D of the gap curvature, for example between two arcs, the pressure contains -(E* D / 2 pi) t ln|t|, with
///   the distance t (Hilbert transform of the curvature; Johnson 1985, eq. 2.25b). No parabola represents this term.
/// Both can be inferred from the pressures and the gap around the peak. No bias is subtracted if the curvature of the
/// gap jumps up and down there (areWaves()), or if the border of the grid cuts the pressure along the track.
double peakPressure(const PatchGap& gap, double modulus, const CellsAround& peak);

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
