// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "core/normal/measures/contact_edge.h"
#include "core/normal/measures/edge_bias.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Inputs for curvature discontinuities near an edge crossing: steps of the SecondDifference of the gap, over the
/// pressure that scales EdgeInputs, in the row of the crossing. The first is the step between the columns three and two
/// inward of the loaded cell; the last is the step from the loaded cell to the next column outward. Outward is away
/// from the pressure; on a line along x, towards the line with less pressure. The steps are limited to ±3 and zero
/// where a body ends.
constexpr int edge_steps = 4;
using EdgeSteps = Eigen::Array<float, edge_steps, 1>;

/// Contact patch and the polygon through its edge.
struct EdgeOf
{
  const EdgePolygon& polygon;  ///< after its cells()
  const PatchGap& gap;
  double modulus;       ///< [Pa]
  double max_pressure;  ///< [Pa]
};

/// Columns near which the curvature of the gap may jump, determined from the middle row. None if `first` exceeds
/// `last`.
struct DiscontinuityColumns
{
  Eigen::Index first, last = -1;

  explicit DiscontinuityColumns(const EdgeOf& edge);
};

/// Finds the steps at a crossing. False if all of them are smooth, or if neither side is outward.
bool findEdgeSteps(const EdgeOf& edge, const EdgeCrossing& crossing, const EdgeInputs& inputs, EdgeSteps& steps);

/// Calls `visit(crossing, inputs, steps)` for the crossings at which the curvature of the gap jumps.
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

/// Bias correction of the area near curvature discontinuities, in addition to EdgeBias. Two one-hidden-layer ReLU
/// networks. The correction is the network output minus the output of the same network with all steps zero.
struct DiscontinuityBias
{
  static constexpr int units = 8, inputs = edge_inputs + edge_steps;
  using Crossing = ReluNetwork<inputs, units>;
  static constexpr int numbers = 2 * Crossing::numbers;

  Crossing along, across;  ///< for lines of cells along x and along y; output [cells]

  /// Bias at a crossing [cells].
  float at(const EdgeCrossing& crossing, const EdgeInputs& shown, const EdgeSteps& steps) const;
};

/// Weights in use. Fitted by test/calibration/fit_discontinuity_bias.cpp in revision e6707df.
const DiscontinuityBias& discontinuityBias();

/// Sums over all crossings [cells]. Of a mirrored pressure: those of the stored half.
struct DiscontinuitySums
{
  double bias = 0;   ///< of the bias
  double sizes = 0;  ///< of the absolute values of the bias
};
DiscontinuitySums sumAtDiscontinuities(const EdgeOf& edge);
}  // namespace wheel_rail_contact::core
