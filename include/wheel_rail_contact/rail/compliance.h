// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact
{
/// Rigid displacement of a rail's head at the loaded section, track axes of one side: outward is away from the track's
/// centre. The displacement belongs to the head's reference point, `ComplianceTable::reference_depth` below the crown
/// on the rail's axis; the roll turns the head about that point.
struct RailDeflection
{
  double lateral = 0;   ///< [m], outward positive
  double vertical = 0;  ///< [m], up positive
  double roll = 0;      ///< [rad], outward positive (the crown moves outward)
};

/// Force of the wheel on the rail head, axes of one side.
struct RailForce
{
  double lateral = 0;   ///< Y [N], outward positive
  double vertical = 0;  ///< Q [N], down positive
  double moment = 0;    ///< about the head's reference point [N m], outward roll positive
};

/// Small-displacement compliance of the head under a force at the same section, in the upright rail's own axes.
///
///   [lateral; roll] = [[lateral_lateral, lateral_roll], [lateral_roll, roll_roll]] [Y; M],
///   vertical = -vertical_vertical Q,
///
/// with M the moment of Y and Q about the reference point. Symmetric by Maxwell-Betti.
struct ComplianceTable
{
  static constexpr double reference_depth = 0.014;  ///< head's reference point below the crown [m]

  double lateral_lateral = 0;    ///< [m/N]
  double lateral_roll = 0;       ///< [rad/N] = [m/(N m)]
  double roll_roll = 0;          ///< [rad/(N m)]
  double vertical_vertical = 0;  ///< [m/N]

  /// @throw std::invalid_argument if the matrix is not finite and positive semidefinite.
  void validate() const;
};

/// Deflection of the head under a force, both in the upright rail's own axes.
RailDeflection deflection(const ComplianceTable& table, const RailForce& force);

/// The same with force and deflection in the track's side axes (outward, up) on a rail inclined by `cant` [rad] towards
/// the track's centre.
RailDeflection deflectionInTrack(const ComplianceTable& table, const RailForce& force, double cant);
}  // namespace wheel_rail_contact
