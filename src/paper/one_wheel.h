// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/balance/wheel_contact.h"
#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core::paper
{
/// The rail's deflection (at the head's reference point) that displaces its crown by `crown`: what the paper's finite
/// elements give is the displacement of the rail's top.
/// @param inclination  inclination of the undeflected rail towards the track's centre [rad]
RailDeflection withCrownDisplaced(const RailDeflection& crown, double inclination);

/// One wheel on one rail at a given roll of the wheelset, under a given vertical load: what the balance of a wheelset
/// solves on either side, for scans in which roll and deflection are given. Side axes.
class OneWheel
{
 public:
  /// `solver` must outlive it. @throw std::invalid_argument for a configuration that is not valid.
  OneWheel(ContactModelConfig config, NormalSolver& solver, const GridSize& size);
  OneWheel(const OneWheel&) = delete;
  OneWheel& operator=(const OneWheel&) = delete;

  /// Displaces the rail's crown from its undeflected place, and turns the rail about it.
  void displaceCrown(const RailDeflection& crown);
  /// Takes over a rail placed elsewhere.
  void setRail(const PlacedRail& rail) { contact_.setRail(rail); }

  /// Solves the contact from cold. @return false if there is no answer.
  /// @param y     wheelset's lateral position, towards this wheel's flange positive [m]
  /// @param roll  of the wheelset, this wheel up positive [rad]
  /// @param load  vertical, of this wheel [N]
  bool solve(double y, double roll, double load);

  // Of the last solution:
  Figures figures() const;
  double countedArea() const;  ///< of all cells with pressure [m²]
  double height() const;       ///< of the axle's centre [m]
  const WheelContact& contact() const { return contact_; }

 private:
  ContactModelConfig config_;
  GridSize size_;
  PlacedRail undeflected_;
  WheelContact contact_;
  RigidTouch touch_;
};

/// A wheelset whose rails are displaced by given amounts, each its own: finds the roll at which both wheels carry
/// `load` at one height of the axle.
/// @param y  towards `first`'s flange positive [m]
/// @return false if there is no answer; otherwise both wheels hold their solution at `roll` (first wheel up positive).
bool rollToBalance(OneWheel& first, OneWheel& second, double y, double load, double& roll);
}  // namespace wheel_rail_contact::core::paper
