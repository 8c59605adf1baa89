// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/measures/contact_edge.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Contact patch and the polygon through its edge.
struct EdgeOf
{
  const EdgePolygon& polygon;  ///< after its cells()
  const PatchGap& gap;
  double modulus;       ///< [Pa]
  double max_pressure;  ///< [Pa]
};

/// Sums over all crossings [cells]. Of a mirrored pressure: those of the stored half.
struct DiscontinuitySums
{
  double bias = 0;   ///< of the bias
  double sizes = 0;  ///< of the absolute values of the bias
};

/// Bias correction of the area near curvature discontinuities, in addition to EdgeBias.
DiscontinuitySums sumAtDiscontinuities(const EdgeOf& edge);
}  // namespace wheel_rail_contact::core
