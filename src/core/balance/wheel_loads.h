// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/sides.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// What determines the loads of the wheels in a state: the vehicle alone, or its moment with those of the contacts
/// (WheelsetConfig::Balance::moments). A value. Loads are vertical [N]; too small ones are zero.
class WheelLoads
{
 public:
  /// Relative change of the overlap per one of the load, of paraboloids (Hertz 1882) [-].
  static constexpr double overlap_per_load = 2.0 / 3;

  WheelLoads() = default;
  WheelLoads(const WheelsetConfig& wheelset, const WheelsetState& state);

  /// Load of both wheels [N].
  double sum() const { return 2 * half_; }
  /// True if the moments determine the loads.
  bool balances() const;
  /// Loads of the wheels: half of the sum, of which `transfer` [N] moves from the left to the right wheel.
  Sides<double> with(double transfer) const;
  /// Loads of which one is `load` [N].
  Sides<double> with(Side side, double load) const;
  /// Loads by the vehicle alone.
  Sides<double> given() const { return with(torque_ / (2 * half_base_)); }
  /// Loads at a change of the transfer [N] for which the overlap of the lighter wheel changes linearly. It grows with
  /// load^(2/3).
  Sides<double> changed(const Sides<double>& loads, double transfer) const;
  /// Loads on the way from `a` to `b`.
  static Sides<double> between(const Sides<double>& a, const Sides<double>& b, double share)
  {
    return {a.left + share * (b.left - a.left), a.right + share * (b.right - a.right)};
  }
  /// True if the loads change to balance the moments.
  bool areCoupled(const Sides<double>& loads) const { return balances() && loads.left > 0 && loads.right > 0; }
  /// True if the moments lift a wheel.
  bool areLifted(const Sides<double>& loads) const { return balances() && !areCoupled(loads); }
  /// The wheel that is lifted then.
  static Side lifted(const Sides<double>& loads) { return loads.left > 0 ? Side::right : Side::left; }
  /// Open moment about the axle centre [N m].
  /// @param moments  of the contacts about the axle centre, positive if they lift their wheel [N m]
  double openMoment(const Sides<double>& moments) const { return torque_ + (moments.left - moments.right); }
  /// True if a wheel is lifted, and the moments return it to its rail.
  /// @param share  of the whole load with which it must return at least: a late search leaves it lifted below the jumps
  /// of the forces
  bool returnWheel(const Sides<double>& loads, const Sides<double>& moments, double share) const;

 private:
  bool by_moments_ = false;
  double half_ = 0;       ///< of the load of both wheels [N]
  double torque_ = 0;     ///< of the vehicle about the axle centre [N m]
  double half_base_ = 1;  ///< half of the distance of the running circles [m]
};
}  // namespace wheel_rail_contact::core
