// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Contact of two half-spaces with the undeformed gap A x² + B y².
struct HertzContact
{
  SolveStatus status = SolveStatus::invalid_problem;  ///< converged, no_contact or invalid_problem
  double semi_axis_x = 0;                             ///< semi-axis of the contact ellipse along x [m]
  double semi_axis_y = 0;                             ///< semi-axis along y [m]
  double max_pressure = 0;                            ///< at the centre [Pa]
  double approach = 0;                                ///< [m]
  double force = 0;                                   ///< [N]
  double area = 0;                                    ///< [m²]
};

/// Coefficients of the gap A x² + B y² [1/m]: half of the relative principal curvatures. x and y are the principal
/// directions.
struct GapCurvature
{
  double a = 0;  ///< A, > 0
  double b = 0;  ///< B, > 0
};

/// Closed form of Hertz 1882 for an approach [m] (Johnson 1985, eq. 4.26 to 4.32). Elliptic integrals by the
/// arithmetic–geometric mean; ellipticity by Newton's method, to rounding. `modulus` is the contact modulus E*
/// [Pa] (positive).
///
/// The status is invalid_problem for curvatures that are not positive, for which no Hertz solution exists, and for
/// values that are not finite. It is no_contact, with all values zero, for an approach that is not positive.
HertzContact hertzForApproach(const GapCurvature& gap, double modulus, double approach);
}  // namespace wheel_rail_contact::core
