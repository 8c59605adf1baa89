// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/normal/measures/cells_around.h"
#include "core/normal/measures/contact_edge.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Peak pressure, between the cells if necessary [Pa]. If a neighbouring cell across the track is not loaded, it is the
/// pressure of the peak cell. The pressure must solve `gap` on its grid, with E* = `modulus` [Pa].
///
/// The value is the maximum of the parabolas through the squared pressures of the peak cell and its neighbours, minus
/// its known bias (doc/theory.md, "Maximum pressure"). No bias is subtracted if the curvature of the gap jumps up and
/// down there (areWaves()), or if the border of the grid cuts the pressure along the track.
double peakPressure(const PatchGap& gap, double modulus, const CellsAround& peak);

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
  /// known bias (contact_edge.h) and the bias at curvature discontinuities of the gap (sumAtDiscontinuities()).
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
