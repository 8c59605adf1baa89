// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Complete elliptic integrals of modulus k² = 1 - kappa²: K, and D = (K - E) / k².
struct Elliptic
{
  double k = 0, d = 0;
};

/// Computes the integrals by the arithmetic–geometric mean (Abramowitz and Stegun 1964, 17.6), without cancellation at
/// kappa = 1. Requires 0 < kappa <= 1.
Elliptic elliptic(double kappa);
}  // namespace wheel_rail_contact::core
