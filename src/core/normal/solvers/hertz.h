// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Contact of two half-spaces whose undeformed gap is A x² + B y².
struct HertzContact
{
  SolveStatus status = SolveStatus::invalid_problem;  ///< converged, no_contact or invalid_problem
  double semi_axis_x = 0;                             ///< of the contact ellipse, along x [m]
  double semi_axis_y = 0;                             ///< along y [m]
  double max_pressure = 0;                            ///< in the middle [Pa]
  double approach = 0;                                ///< [m]
  double force = 0;                                   ///< [N]
  double area = 0;                                    ///< [m²]
};

/// Coefficients of the gap A x² + B y² [1/m]: half the relative principal curvatures. x and y are principal directions.
struct GapCurvature
{
  double a = 0;  ///< A, > 0
  double b = 0;  ///< B, > 0
};

/// Hertz 1882 in closed form (Johnson 1985, eq. 4.26 to 4.32); elliptic integrals by the arithmetic–geometric mean,
/// ellipticity by Newton's method to rounding. `modulus` is the contact modulus E* [Pa], > 0.
///
/// Curvatures that are not positive, or values that are not finite, give invalid_problem: Hertz has no answer there. A
/// force or approach that is not positive gives no_contact and zeros.
HertzContact hertzForForce(const GapCurvature& gap, double modulus, double force);
/// Likewise for an approach [m] in place of a force [N].
HertzContact hertzForApproach(const GapCurvature& gap, double modulus, double approach);
}  // namespace wheel_rail_contact::core
