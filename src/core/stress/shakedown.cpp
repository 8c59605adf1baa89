// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/shakedown.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
const double tension_over_shear = std::sqrt(3.0);  ///< of stresses with the same von Mises stress [-]
}  // namespace

double loadFactor(double max_pressure, double yield)
{
  return yield > 0 ? max_pressure * tension_over_shear / yield : 0;
}

double shakedownLimit(double max_pressure, double orthogonal, double von_mises)
{
  // Half of two changes of the stress during a passage: of xz, which changes its sign, and of a stress that comes and
  // goes.
  const double range = std::max(orthogonal, 0.5 * von_mises / tension_over_shear);
  return range > 0 ? max_pressure / range : 0;
}
}  // namespace wheel_rail_contact::core
