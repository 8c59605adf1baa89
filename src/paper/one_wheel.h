// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/balance/wheel_contact.h"
#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core::paper
{
/// Deflection of the rail at the reference point of the head, from a displacement `crown` of its crown. The
/// finite-element result of the paper is the displacement of the top of the rail.
/// @param inclination  inclination of the undeflected rail towards the track centre [rad]
RailDeflection withCrownDisplaced(const RailDeflection& crown, double inclination);

/// The left wheel on its rail at a given roll of the wheelset and a given vertical load, side axes. This is the part of
/// the wheelset balance for one side, for scans in which roll and deflection are given.
class OneWheel
{
 public:
  /// Keeps a reference to `solver`, which must outlive this. @throw std::invalid_argument for an invalid configuration
  OneWheel(ContactModelConfig config, NormalSolver& solver, const GridSize& size);
  OneWheel(const OneWheel&) = delete;
  OneWheel& operator=(const OneWheel&) = delete;

  /// Displaces the crown of the rail from its undeflected position and turns the rail about it.
  void displaceCrown(const RailDeflection& crown);
  /// Sets a rail in a given position.
  void setRail(const PlacedRail& rail) { contact_.setRail(rail); }

  /// Solves the contact from a cold start. @return false if there is no solution
  /// @param y     lateral position of the wheelset, towards the flange of this wheel positive [m]
  /// @param roll  roll of the wheelset, this wheel up positive [rad]
  /// @param load  vertical load of this wheel [N]
  bool solve(double y, double roll, double load);

  // Results of the last solution:
  Figures figures() const;
  double countedArea() const;                          ///< area of all cells with pressure [m²]
  double height() const { return contact_.height(); }  ///< of the axle centre [m]
  /// Change of the height by roll under the same load [m/rad].
  double heightPerRoll();
  const WheelContact& contact() const { return contact_; }

 private:
  ContactModelConfig config_;
  PlacedRail undeflected_;
  WheelContact contact_;
};

/// Finds the roll at which both wheels of a wheelset carry `load` at one height of the axle. The displacement of each
/// rail is given.
/// @param y  lateral position, towards the flange of `first` positive [m]
/// @return false if there is no solution; otherwise both wheels have their solutions at `roll` (first wheel up
/// positive)
bool rollToBalance(OneWheel& first, OneWheel& second, double y, double load, double& roll);
}  // namespace wheel_rail_contact::core::paper
