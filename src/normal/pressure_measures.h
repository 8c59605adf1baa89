// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// Reads force, maximum, area and border contact off a pressure. Keeps scratch
/// memory, so that shapes seen before allocate nothing.
class PressureMeasures
{
 public:
  /// Fills force, max_pressure, area and touches_border of `patch` from its
  /// grid and pressure.
  ///
  /// max_pressure: the highest cell's value, raised to the top of the parabolas
  /// along and across through the squares of it and its neighbours (exact for
  /// an ellipsoidal pressure). Against 512 × 256 cells this halves the error or
  /// better on 16 × 32 and more cells; see the tests. area: the polygon through
  /// the points where the edge of the contact crosses the lines of cell
  /// centres, see contact_edge.h.
  void measure(PatchPressure& patch);

 private:
  Eigen::ArrayXXd framed_;  ///< pressure with a frame of zeros, or of mirrored
                            ///< cells at x = 0 of a symmetric grid
};
}  // namespace wheel_rail_contact
