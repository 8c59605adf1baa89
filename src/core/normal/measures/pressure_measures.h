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
  /// Fills force, max_pressure, area, axis_ratio, moved_at_discontinuities and touches_border of `patch` from its grid
  /// and pressure. The pressure must solve `gap` with E* = `modulus` [Pa].
  ///
  /// max_pressure: the largest peakPressure() of all cells that are the highest of their column and not exceeded by a
  /// neighbouring column. A peak between two cells, for example at a curvature discontinuity, may be higher than a peak
  /// at a cell centre.
  ///
  /// area: the area of the polygon through the crossings of the contact edge with the lines of cell centres, minus its
  /// known bias (contact_edge.h) and the bias at curvature discontinuities of the gap (discontinuity_bias.h).
  void measure(const PatchGap& gap, double modulus, PatchPressure& patch);
  /// Fills axis_ratio only.
  void measureRatio(PatchPressure& patch);

 private:
  EdgePolygon polygon_;
};

/// Semi-axes of an ellipse along the axes of a grid [m].
struct SemiAxes
{
  double along = 0;   ///< along x (along the track)
  double across = 0;  ///< along y
};

/// Ellipse with the area of a contact and the ratio of its axes, PatchPressure::axis_ratio.
SemiAxes equalEllipse(const PatchPressure& patch);

/// Normal stiffness of a contact, the change of its force per approach [N/m].
///
/// When the approach grows, the pressure grows as that under a flat punch with the shape of the contact (Barber 2003).
/// For an ellipse with the semi-axes a >= b it is pi E* a / K(k) with k² = 1 - b²/a² and the complete elliptic integral
/// K. On a contact of Hertz it is the derivative of the load by the approach (Johnson 1985, eq. 4.26).
/// @param modulus  contact modulus E* [Pa]
double punchStiffness(const SemiAxes& axes, double modulus);

/// Complete elliptic integrals of modulus k² = 1 - kappa²: K, and D = (K - E) / k².
struct Elliptic
{
  double k = 0, d = 0;
};

/// Computes the integrals by the arithmetic–geometric mean (Abramowitz and Stegun 1964, 17.6), without cancellation at
/// kappa = 1. Requires 0 < kappa <= 1.
Elliptic elliptic(double kappa);
}  // namespace wheel_rail_contact::core
