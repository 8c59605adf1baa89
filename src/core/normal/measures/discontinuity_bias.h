// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "core/normal/measures/contact_edge.h"
#include "core/normal/measures/edge_bias.h"
#include "core/normal/measures/relu_network.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Steps of the gap's SecondDifference over the pressure that EdgeInputs are over, in the row of an edge's crossing:
/// between the columns three and two inward from its loaded cell, and so on to that between it and the next one
/// outward, at most 3. Outward is away from the pressure; on a line along x, to the side where the next line carries
/// less. Zero where a body ends.
constexpr int edge_steps = 4;
using EdgeSteps = Eigen::Array<float, edge_steps, 1>;

/// A patch whose edge is looked at.
struct EdgeOf
{
  const EdgePolygon& polygon;  ///< through the edge of the pressure, after its cells()
  const PatchGap& gap;
  double modulus;       ///< [Pa]
  double max_pressure;  ///< [Pa]
};

/// Columns about which the gap's curvature may jump, by its middle row; none if `first` is above `last`.
struct DiscontinuityColumns
{
  Eigen::Index first, last = -1;

  explicit DiscontinuityColumns(const EdgeOf& edge);
};

/// Steps at a crossing where `inputs` show; false if all of them are smooth, and where neither side is outward.
bool findEdgeSteps(const EdgeOf& edge, const EdgeCrossing& crossing, const EdgeInputs& inputs, EdgeSteps& steps);

/// Calls `visit(crossing, inputs, steps)` for the crossings at which the gap's curvature jumps.
template <typename Visit>
void visitEdgeDiscontinuities(const EdgeOf& edge, Visit visit)
{
  const DiscontinuityColumns columns(edge);
  EdgeSteps steps;
  for (std::size_t k = 0; k < edge.polygon.crossings().size() && columns.first <= columns.last; ++k)
  {
    const EdgeCrossing& crossing = edge.polygon.crossings()[k];
    const EdgeInputs& inputs = edge.polygon.inputs()[k];
    const Eigen::Index column = edge.polygon.loadedCell(crossing).column;
    if (column >= columns.first && column <= columns.last && findEdgeSteps(edge, crossing, inputs, steps))
    {
      visit(crossing, inputs, steps);
    }
  }
}

/// What a polygon through the edge's crossings, less its EdgeBias, is too large by where the gap's curvature jumps:
/// ramps of what shows at a crossing and of the steps there, less the same ramps without steps, so that it goes with
/// them.
struct DiscontinuityBias
{
  static constexpr int units = 8, inputs = edge_inputs + edge_steps;
  using Crossing = ReluNetwork<inputs, units>;
  static constexpr int numbers = 2 * Crossing::numbers;

  Crossing along, across;  ///< for lines of cells along x and along y [cells]

  /// At a crossing where those show [cells].
  float at(const EdgeCrossing& crossing, const EdgeInputs& shown, const EdgeSteps& steps) const;
};

/// The weights in use. Fitted by test/calibration/fit_discontinuity_bias.cpp.
const DiscontinuityBias& discontinuityBias();

/// Sums over all crossings, of a mirrored pressure those of the stored half [cells].
struct DiscontinuitySums
{
  double bias = 0;   ///< of the polygon
  double sizes = 0;  ///< of what it is made of
};
DiscontinuitySums sumAtDiscontinuities(const EdgeOf& edge);
}  // namespace wheel_rail_contact::core
