// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_edge.h"
#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// How much three squared pressures bend down, the middle one being the highest [Pa²].
inline double bendOf(double before, double top, double after)
{
  return 2 * top * top - before * before - after * after;
}

/// Rise of the parabola through three squared pressures above the middle one, which is the highest; zero at an edge
/// [Pa²].
inline double riseOf(double before, double top, double after)
{
  const double slope = (after - before) * (after + before);
  const double bend = bendOf(before, top, after);
  return bend > 0 && before > 0 && after > 0 ? slope * slope / (8 * bend) : 0;
}

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
