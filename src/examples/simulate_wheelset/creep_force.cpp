// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/creep_force.h"

#include <cmath>

#include "wheel_rail_contact/core/creep.h"

namespace simulate_wheelset
{
namespace core = wheel_rail_contact::core;

namespace
{
/// Resultant over the friction limit, for its linear value `demand` over the limit (Vermeulen and Johnson 1964).
double saturated(double demand)
{
  return demand < CreepForce::saturation ? demand * (1 - demand / 3 + demand * demand / 27) : 1;
}
}  // namespace

CreepForce CreepLaw::force(const ContactEllipse& ellipse, const Creepage& creepage) const
{
  const core::KalkerCoefficients c = core::kalkerCoefficients(ellipse.along / ellipse.across, parameters_.poisson);
  const double product = ellipse.along * ellipse.across, cube = std::pow(product, 1.5);
  const double g = parameters_.shear_modulus;
  CreepForce force;
  force.along = -g * product * c.c11 * creepage.along;
  force.across = -g * (product * c.c22 * creepage.across + cube * c.c23 * creepage.spin);
  force.moment = g * (cube * c.c23 * creepage.across - product * product * c.c33 * creepage.spin);
  force.demand = std::hypot(force.along, force.across) / (parameters_.friction * ellipse.normal_force);
  const double scale = force.demand > 0 ? saturated(force.demand) / force.demand : 1;
  force.along *= scale;
  force.across *= scale;
  force.moment *= scale;
  return force;
}
}  // namespace simulate_wheelset
