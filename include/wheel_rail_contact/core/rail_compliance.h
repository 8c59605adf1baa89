// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
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

/// The same with force and deflection in the track's side axes (outward, up) on a rail inclined by `inclination` [rad] towards
/// the track's centre.
RailDeflection deflectionInTrack(const ComplianceTable& table, const RailForce& force, double inclination);

/// How the rails give way.
struct RailBendingConfig
{
  /// What sets the rails' deflection.
  enum class Model
  {
    none,        ///< rails stay where they are
    prescribed,  ///< by `prescribed`
    compliance   ///< by `table` and the forces
  };
  /// The lateral force that bends a rail.
  enum class LateralForce
  {
    contact,  ///< the outward share of the contact's normal forces
    topic,    ///< given with every state (WheelsetState::rail_lateral_force)
    constant  ///< `lateral_force_value`
  };
  Model model = Model::none;                           ///< what sets the deflection
  RailDeflection prescribed;                           ///< for model prescribed, the same on both rails
  ComplianceTable table;                               ///< for model compliance
  LateralForce lateral_force = LateralForce::contact;  ///< for model compliance
  double lateral_force_value = 0;                      ///< outward positive [N]
};

/// Checks every option against its rule.
/// @throw std::invalid_argument with the option, its value and the broken rule.
void validate(const RailBendingConfig& bending);
}  // namespace wheel_rail_contact::core
