// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "core/normal/solvers/hertz.h"

namespace wheel_rail_contact::core
{
/// Contact under a force [N]. The force grows with the approach to the power 3/2.
inline HertzContact hertzForForce(const GapCurvature& gap, double modulus, double force)
{
  return hertzForApproach(gap, modulus, std::pow(force / hertzForApproach(gap, modulus, 1).force, 2.0 / 3));
}
}  // namespace wheel_rail_contact::core
