// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "core/normal/measures/relu_network.h"

namespace wheel_rail_contact::core
{
/// Where the contact's edge crosses a line of cell centres, between a loaded cell and one that is not.
struct EdgeCrossing
{
  const double* loaded;     ///< pressure of the loaded cell; read are one cell outward to two inward, also beside it
  std::ptrdiff_t outward;   ///< step to the empty cell
  std::ptrdiff_t sideways;  ///< step to the next line
  bool along;               ///< the line runs along x
};

/// What shows there, with the cells' pressures over the largest among the crossing's loaded cell, the next one inward
/// and those beside the two: the three cells of the line from the loaded one inward; for the empty cell and these
/// three, the mean of the pressures on the lines on either side, then half of their difference; half of the logarithm
/// of the cells' extent along the line over that square to it; one. Cells off the contact count as 0, and so does the
/// third of a line behind an empty second; pressures above 1.5 count as that, cells of more than e^3.5 in shape as of
/// that.
constexpr int edge_inputs = 13;
using EdgeInputs = Eigen::Array<float, edge_inputs, 1>;

/// @param longer  logarithm of the cells' length along x over their width
EdgeInputs edgeInputs(const EdgeCrossing& crossing, double longer);

/// What a polygon through the edge's crossings (EdgePolygon) is too large by: at each crossing by what shows there, and
/// for each island of the contact.
struct EdgeBias
{
  static constexpr int units = 16;
  using Crossing = ReluNetwork<edge_inputs, units>;
  static constexpr int numbers = Crossing::numbers + 2;  ///< all of the below

  Crossing crossing;    ///< for every crossing [cells]
  float island = 0;     ///< for every island [cells]
  float few_cells = 0;  ///< the same, times the island's area [cells²]

  /// For a contact of `polygon` cells on so many islands, taken as alike, besides its crossings [cells].
  double of(double polygon, int islands) const;
};

/// The weights in use. Fitted by test/calibration/fit_edge_bias.cpp.
const EdgeBias& edgeBias();
}  // namespace wheel_rail_contact::core
