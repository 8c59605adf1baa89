// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/corner_stress.h"

#include <cmath>

#include "core/pi.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double half_over_pi = 0.5 / pi;
}  // namespace

Stress cornerStress(double x, double y, double z, double poisson)
{
  const double xx = x * x, yy = y * y, zz = z * z;
  const double r = std::sqrt(xx + yy + zz);
  // At the surface the limits z -> 0 of the terms with z are zero, also above the axes through the corner.
  const double z_xz = zz > 0 ? z / (xx + zz) : 0, z_yz = zz > 0 ? z / (yy + zz) : 0;  // z over (x² + z²) and (y² + z²)
  const double product = x * y / r;
  const double v_z = -std::atan2(x * y, z * r);
  const double chi_xx = std::atan2(x * y * (r - z), xx * r + z * yy);
  const double chi_yy = -v_z - chi_xx;
  const double bulk = 1 - 2 * poisson;
  Stress s;
  s.xx = half_over_pi * (2 * poisson * v_z - bulk * chi_xx + product * z_xz);
  s.yy = half_over_pi * (2 * poisson * v_z - bulk * chi_yy + product * z_yz);
  s.zz = half_over_pi * (v_z - product * (z_xz + z_yz));
  s.xz = half_over_pi * y * z * z_xz / r;
  s.yz = half_over_pi * x * z * z_yz / r;
  s.xy = -half_over_pi * (bulk * std::log(r + z) + z / r);
  return s;
}
}  // namespace wheel_rail_contact::core
