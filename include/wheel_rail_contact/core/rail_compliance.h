// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
/// Rigid displacement of a rail head, in the axes of its side: outward (away from the track centre) and up (+z).
///
/// Lateral and vertical displacement are those of the reference point of the head. It lies on the axis of the rail,
/// ComplianceTable::reference_depth below the crown. The roll turns the head about this point.
struct RailDeflection
{
  double lateral = 0;   ///< lateral displacement [m], outward positive
  double vertical = 0;  ///< vertical displacement [m], up positive
  double roll = 0;      ///< rotation of the head [rad], positive if the crown moves outward
};

/// Change of a RailDeflection in time [m/s], [rad/s], or along the track [-], [rad/m]; side axes.
struct RailRates
{
  double lateral = 0;   ///< of the reference point, outward positive
  double vertical = 0;  ///< of the reference point, up positive
  double roll = 0;      ///< rotation of the head, positive if the crown moves outward
};

/// Adds a small displacement of the same rail head.
inline RailDeflection& operator+=(RailDeflection& sum, const RailDeflection& added)
{
  sum.lateral += added.lateral;
  sum.vertical += added.vertical;
  sum.roll += added.roll;
  return sum;
}

/// Force of a wheel on a rail head, in the axes of its side.
struct RailForce
{
  double lateral = 0;   ///< lateral force Y [N], outward positive
  double vertical = 0;  ///< vertical force Q [N], down positive
  double moment = 0;    ///< moment about the reference point of the head [N m], positive if it turns the head outward
};

/// Compliance of a rail head: its small displacement by a force, in the axes of the upright rail.
///
///   [lateral; roll] = [[lateral_lateral, lateral_roll], [lateral_roll, roll_roll]] [Y; M],
///   vertical = -vertical_vertical Q,
///
/// with M the moment of Y and Q about the reference point of the head. Force and displacement belong to the same
/// section of the rail. The matrix is symmetric (Maxwell-Betti). The default is a rigid rail.
struct ComplianceTable
{
  static constexpr double reference_depth = 0.014;  ///< depth of the reference point below the crown [m]

  double lateral_lateral = 0;    ///< lateral displacement per lateral force [m/N]
  double lateral_roll = 0;       ///< roll per lateral force [rad/N] = lateral displacement per moment [m/(N m)]
  double roll_roll = 0;          ///< roll per moment [rad/(N m)]
  double vertical_vertical = 0;  ///< downward displacement per vertical force [m/N]

  /// Checks that all entries are finite and the matrix is positive semidefinite.
  /// @throw std::invalid_argument with the name of the wrong entry.
  void validate() const;
};

/// Deflection of a rail head under a force, both in the axes of the upright rail.
RailDeflection deflection(const ComplianceTable& table, const RailForce& force);

/// Deflection of a rail head under a force, both in track axes (outward, up). The rail is inclined by `inclination`
/// [rad] towards the track centre.
RailDeflection deflectionInTrack(const ComplianceTable& table, const RailForce& force, double inclination);

/// Deflection of the rails.
struct RailBendingConfig
{
  /// Source of the deflection.
  enum class Model
  {
    none,        ///< rigid rails
    prescribed,  ///< constant deflection `prescribed`
    compliance   ///< computed from the forces with the compliance table `table`
  };
  /// Source of the lateral force that bends a rail.
  enum class LateralForce
  {
    contact,  ///< outward component of the forces of the contact: normal forces, and friction with CreepConfig::method
    topic,    ///< given with each state (WheelsetState::rail_lateral_force)
    constant  ///< constant force `lateral_force_value`
  };
  Model model = Model::none;                           ///< source of the deflection
  RailDeflection prescribed;                           ///< deflection of both rails, for Model::prescribed
  Sides<ComplianceTable> table;                        ///< compliance of each rail, for Model::compliance
  LateralForce lateral_force = LateralForce::contact;  ///< source of the lateral force, for Model::compliance
  double lateral_force_value = 0;                      ///< for LateralForce::constant [N], outward positive
};

/// Checks every parameter: prescribed displacements up to 0.1 m and roll up to 0.2 rad, a finite lateral force, a valid
/// table.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const RailBendingConfig& bending);
}  // namespace wheel_rail_contact::core
