// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/measures/contact_edge.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Computes force, maximum pressure, area and border contact from a pressure. Keeps scratch memory: shapes that
/// occurred before allocate nothing.
class PressureMeasures
{
 public:
  /// Fills force, max_pressure, area, moved_at_discontinuities and touches_border of `patch` from its grid and
  /// pressure. The pressure must solve `gap` with E* = `modulus` [Pa].
  ///
  /// max_pressure: the largest peakPressure() of all cells that are the highest of their column and not exceeded by a
  /// neighbouring column. A peak between two cells, for example at a curvature discontinuity, may be higher than a peak
  /// at a cell centre.
  ///
  /// area: the area of the polygon through the crossings of the contact edge with the lines of cell centres, minus its
  /// known bias (contact_edge.h) and the bias at curvature discontinuities of the gap (discontinuity_bias.h).
  void measure(const PatchGap& gap, double modulus, PatchPressure& patch);

 private:
  EdgePolygon polygon_;
};
}  // namespace wheel_rail_contact::core
