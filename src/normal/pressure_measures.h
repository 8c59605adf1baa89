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
  /// max_pressure: of each column's highest cell that no neighbouring column's exceeds, its value raised to the top of
  /// the parabolas along and across through the squares of it and its neighbours (exact for an ellipsoidal pressure),
  /// less what cells of constant pressure are known to hold too much there; the largest of these, but never below the
  /// highest cell. A crest between two cells, as at a joint of the profiles, may be higher than one that a cell meets.
  ///
  /// area: the polygon through the points where the edge of the contact crosses the lines of cell centres, less
  /// what it is known to be off, see contact_edge.h.
  void measure(PatchPressure& patch);

 private:
  /// Highest pressure about a cell that no neighbour exceeds, between the cells if it lies there [Pa].
  double topAt(Eigen::Index row, Eigen::Index column) const;

  EdgePolygon polygon_;
};
}  // namespace wheel_rail_contact
