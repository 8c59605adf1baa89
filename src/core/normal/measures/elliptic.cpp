// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/elliptic.h"

#include <cmath>

#include "core/pi.h"

namespace wheel_rail_contact::core
{
Elliptic elliptic(double kappa)
{
  double mean = 0.5 * (1 + kappa), root = std::sqrt(kappa);
  double c = 0.5 * (1 - kappa);
  // Sum of 2^n c_n² over c_0² = k², with c_1² / k² = (1 - kappa) / (4 (1 + kappa)).
  double share = 1 + 0.5 * (1 - kappa) / (1 + kappa);
  const double modulus_squared = (1 - kappa) * (1 + kappa);
  for (double power = 4; c * c > 1e-17 * mean * mean; power *= 2)
  {
    const double next = 0.5 * (mean + root);
    root = std::sqrt(mean * root);
    c = 0.25 * c * c / next;
    mean = next;
    share += modulus_squared > 0 ? power * c * c / modulus_squared : 0;
  }
  Elliptic result;
  result.k = 0.5 * pi / mean;
  result.d = 0.5 * result.k * share;
  return result;
}
}  // namespace wheel_rail_contact::core
