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
constexpr int peak_reach = 4;       ///< columns beside a crest that are looked at
constexpr double largest_step = 2;  ///< GapSteps of more count as that
constexpr int peak_inputs = 19;     ///< of each side

/// What shows about a crest.
struct PeakInputs
{
  using Side = Eigen::Array<float, peak_inputs, 1>;

  std::array<EdgeInputs, 2> tips;  ///< at the crossings of the edge that end the crest's line along
  /// The crest's row from its first column on, and from its last on, where the steps have the other sign. By how much
  /// the pressures of peak_reach columns before it and after it fall short of the crest's, over that (a higher crest
  /// counts as equally high); GapSteps between those columns; by how much the mean of the cells before and after it
  /// along falls short, and half of their difference; the root of the steps' squares.
  std::array<Side, 2> sides;
  double along = 0;  ///< the crest's bend along

  /// @param longer  logarithm of the cells' length along x over their width
  PeakInputs(const CellsAround& peak, const GapSteps& steps, double longer);
};

/// Something is known of the excess: the crest has loaded cells beside it, the gap's curvature does not go to and fro
/// about it, and the grid's border does not cut the pressure along.
bool showsBias(const CellsAround& peak, const GapSteps& steps);

/// What the top of the parabolas through the squared pressures of a crest and its neighbours is too large by.
struct PeakBias
{
  static constexpr int tip_units = 8, side_units = 16;
  using Tip = ReluNetwork<edge_inputs, tip_units>;
  using Side = ReluNetwork<peak_inputs, side_units>;
  static constexpr int numbers = Tip::numbers + Side::numbers;

  Tip tip;    ///< from each tip, over the bend along
  Side side;  ///< from the row as seen from each side

  /// Over the true pressure [-].
  double of(const PeakInputs& inputs) const;
};

/// The weights in use. Fitted by test/calibration/fit_peak_bias.cpp.
const PeakBias& peakBias();
}  // namespace wheel_rail_contact::core
