// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_edge.h"
#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// Reads force, maximum, area and border contact off a pressure. Keeps scratch memory, so that shapes seen before
/// allocate nothing.
class PressureMeasures
{
 public:
  /// Fills force, max_pressure, area and touches_border of `patch` from its grid and pressure.
  ///
  /// max_pressure: the highest cell's value, raised to the top of the parabolas along and across through the squares of
  /// it and its neighbours (exact for an ellipsoidal pressure), less what cells of constant pressure are known to hold
  /// too much there, but never below the highest cell.
  ///
  /// area: the polygon through the points where the edge of the contact crosses the lines of cell centres, less
  /// what it is known to be off, see contact_edge.h.
  void measure(PatchPressure& patch);

 private:
  EdgePolygon polygon_;
};
}  // namespace wheel_rail_contact
