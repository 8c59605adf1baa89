// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/hertz.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/normal/measures/pressure_measures.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Ratio b/a <= 1 of the axes of the contact ellipse for curvatures in the ratio A/B <= 1. A belongs to the longer
/// axis.
///
/// Solves B/A = (K - D) / (kappa² D) for log kappa by Newton's method. The first value kappa = (A/B)^(2/3) is accurate
/// to a few per cent for round contacts.
double axesRatio(double curvature_ratio, Elliptic& integrals)
{
  double log_kappa = 2.0 / 3.0 * std::log(curvature_ratio);
  const double target = -std::log(curvature_ratio);
  for (int step = 0; step < 8; ++step)
  {
    const double kappa = std::exp(log_kappa);
    integrals = elliptic(kappa);
    const double rest = integrals.k - integrals.d, squared = kappa * kappa, m = 1 - squared;
    const double error = std::log(rest / (squared * integrals.d)) - target;
    // Derivatives of K and D with respect to m = k² (for D near the circle: its limit).
    const double k_slope = rest / (2 * squared);
    const double d_slope = m > 1e-4 ? (rest / squared - integrals.d) / (2 * m) : 3 * pi / 32;
    const double slope = -2 * squared * ((k_slope - d_slope) / rest - d_slope / integrals.d) - 2;
    log_kappa = std::min(log_kappa - error / slope, 0.0);
    if (std::abs(error) < 1e-8)  // the step just made squares the error
    {
      break;
    }
  }
  const double kappa = std::exp(log_kappa);
  integrals = elliptic(kappa);
  return kappa;
}

bool isPositive(double value)
{
  return value > 0 && std::isfinite(value);
}

/// Computes all values from the shape of the ellipse. `longer` is its longer semi-axis.
HertzContact fromShape(const GapCurvature& gap, double modulus, double longer, double kappa, const Elliptic& integrals)
{
  HertzContact contact;
  contact.status = SolveStatus::converged;
  const bool long_in_x = gap.a <= gap.b;
  const double curvature = std::min(gap.a, gap.b);
  contact.semi_axis_x = long_in_x ? longer : kappa * longer;
  contact.semi_axis_y = long_in_x ? kappa * longer : longer;
  contact.max_pressure = modulus * curvature * longer / (kappa * integrals.d);
  contact.approach = curvature * longer * longer * integrals.k / integrals.d;
  contact.area = pi * kappa * longer * longer;
  contact.force = 2.0 / 3.0 * contact.max_pressure * contact.area;
  return contact;
}
}  // namespace

HertzContact hertzForApproach(const GapCurvature& gap, double modulus, double approach)
{
  HertzContact contact;
  if (!isPositive(gap.a) || !isPositive(gap.b) || !isPositive(modulus) || !std::isfinite(approach))
  {
    return contact;
  }
  if (approach <= 0)
  {
    contact.status = SolveStatus::no_contact;
    return contact;
  }
  const double curvature = std::min(gap.a, gap.b);
  Elliptic integrals;
  const double kappa = axesRatio(curvature / std::max(gap.a, gap.b), integrals);
  const double longer = std::sqrt(approach * integrals.d / (curvature * integrals.k));
  return fromShape(gap, modulus, longer, kappa, integrals);
}
}  // namespace wheel_rail_contact::core
