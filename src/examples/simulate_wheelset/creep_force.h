// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "examples/simulate_wheelset/parameters.h"

namespace simulate_wheelset
{
/// Velocity of the wheel relative to the rail at a contact, divided by the running speed. Patch frame: x forward, y
/// left in the tangent plane, z out of the rail.
struct Creepage
{
  double along = 0;   ///< along x [-]
  double across = 0;  ///< along y [-]
  double spin = 0;    ///< rotation about z, right-handed [1/m]
};

/// Tangential force of the rail on the wheel at a contact, patch frame.
struct CreepForce
{
  double along = 0;   ///< along x [N]
  double across = 0;  ///< along y [N]
  double moment = 0;  ///< about z, right-handed [N m]
  double demand = 0;  ///< force of the linear theory over the friction limit [-]

  /// Demand from which the force is the friction limit (Vermeulen and Johnson 1964).
  static constexpr double saturation = 3;
  /// Whether the force is the friction limit.
  bool isSaturated() const { return demand >= saturation; }
};

/// Ellipse and normal force of a contact.
struct ContactEllipse
{
  double along = 0;         ///< semi-axis a, along the rolling direction [m], > 0
  double across = 0;        ///< semi-axis b [m], > 0
  double normal_force = 0;  ///< [N], > 0
};

/// Creep forces from the linear theory with a limit by friction.
///
/// Linear theory (Kalker 1967; Kalker 1990, table E3 for the coefficients): F_x = -G a b C11 nu_x, F_y = -G (a b C22
/// nu_y + c^3 C23 phi) and M_z = G (c^3 C23 nu_y - c^4 C33 phi), with c^2 = a b. The signs are those of the patch frame
/// above. Limit: Shen, Hedrick and Elkins (1983): force and moment are scaled so that the resultant of F_x and F_y
/// becomes mu N (e - e^2/3 + e^3/27) with its linear value e mu N, and mu N for e >= 3 (Vermeulen and Johnson 1964).
class CreepLaw
{
 public:
  explicit CreepLaw(const CreepParameters& parameters) : parameters_(parameters) {}

  /// Force at a contact.
  CreepForce force(const ContactEllipse& ellipse, const Creepage& creepage) const;

 private:
  CreepParameters parameters_;
};
}  // namespace simulate_wheelset
