// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/measures/contact_edge.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Reads force, maximum, area and border contact off a pressure. Keeps scratch memory, so that shapes seen before
/// allocate nothing.
class PressureMeasures
{
 public:
  /// Fills force, max_pressure, area, moved_at_discontinuities and touches_border of `patch` from its grid and
  /// pressure, which solves `gap` with E* = `modulus` [Pa].
  ///
  /// max_pressure: the largest peakPressure() of each column's highest cell that no neighbouring column's exceeds. A
  /// crest between two cells, as at a joint of the profiles, may be higher than one that a cell meets.
  ///
  /// area: the polygon through the points where the edge of the contact crosses the lines of cell centres, less
  /// what it is known to be off, see contact_edge.h, and what jumps of the gap's curvature add to that, see
  /// discontinuity_bias.h.
  void measure(const PatchGap& gap, double modulus, PatchPressure& patch);

 private:
  EdgePolygon polygon_;
};
}  // namespace wheel_rail_contact::core
