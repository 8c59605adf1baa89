// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "examples/simulate_wheelset/parameters.h"

namespace simulate_wheelset
{
/// Creepage and spin coefficients of the linear theory of rolling contact [-].
struct KalkerCoefficients
{
  double c11 = 0;  ///< longitudinal creepage to longitudinal force
  double c22 = 0;  ///< lateral creepage to lateral force
  double c23 = 0;  ///< spin to lateral force; with the other sign, lateral creepage to moment
  double c33 = 0;  ///< spin to moment
};

/// The coefficients over the ratio of the semi-axes of an elliptic contact, for one Poisson's ratio.
///
/// Source: Kalker (1990), Three-dimensional elastic bodies in rolling contact, table E3; also in Johnson (1985),
/// Contact mechanics, section 8.4. The table has 19 ratios a/b from 0.1 to 10, and the Poisson's ratios 0, 1/4 and 1/2.
/// Between these, the polynomial of second order through the three values is used.
class KalkerTable
{
 public:
  /// @param poisson Poisson's ratio of both bodies [-], 0 to 0.5
  /// @throw std::invalid_argument if it is out of range.
  explicit KalkerTable(double poisson);

  /// Coefficients at a ratio of the semi-axes. The logarithm of each is linear in that of a/b between the ratios of the
  /// table. Beyond its ends the last line is continued, as the asymptotic formulas are nearly powers of a/b: see
  /// contains().
  /// @param ratio a/b [-], > 0: a along the rolling direction, b across
  KalkerCoefficients at(double ratio) const;

  /// True if the ratio a/b is within the table.
  static bool contains(double ratio);

 private:
  std::vector<std::array<double, 4>> logarithms_;  ///< of c11, c22, c23, c33 at each ratio of the table
};

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
  explicit CreepLaw(const CreepParameters& parameters);

  /// Force at a contact.
  CreepForce force(const ContactEllipse& ellipse, const Creepage& creepage) const;

 private:
  CreepParameters parameters_;
  KalkerTable table_;
};
}  // namespace simulate_wheelset
