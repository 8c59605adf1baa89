// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Loads of both wheels that balance force and moment of the vehicle (WheelsetConfig::Balance::moments).
///
/// The unknown is the transfer t: half the load of the right wheel minus that of the left one. The open moment T + M_l
/// + M_r falls with t where the wheelset is stable; T is the moment of the vehicle, M those of the contacts. It is zero
/// at a transfer between the ones at which a wheel carries no load, or the wheelset lifts a wheel. Newton's method
/// starts with the lever arms of the contacts as the slope and continues with secants; bisection takes over where a
/// step leaves the bracket.
class LoadTransfer
{
 public:
  /// Begins a search.
  /// @param load    sum of both wheel loads [N], >= 0
  /// @param torque  moment T of the vehicle about the axle centre [N m]
  /// @param levers  sum of the lever arms of both wheels: the moment of each contact, positive if it lifts its own
  /// wheel,
  ///                over its load [m]
  /// @param uneven  lever arm of the left wheel minus that of the right one [m]
  void begin(double load, double torque, double levers, double uneven);

  /// Transfer t [N]: the wheels carry load/2 - t on the left and load/2 + t on the right.
  double transfer() const { return transfer_; }
  /// Forgets the bracket, because the next moments are those of other grids.
  void widen();
  /// Takes the open moment at the transfer [N m] and the sum of the lever arms [m], and moves to the next transfer.
  /// @return the movement [N]; 0 if a wheel carries no load and a greater transfer would be required
  double improve(double open, double levers);
  /// True if the last call found that a wheel lifts: the moment stays open.
  bool lifts() const { return lifts_; }

 private:
  double within(double transfer) const;

  double half_load_ = 0;
  double transfer_ = 0;
  double least_ = 0, most_ = 0;          ///< bracket of the transfer [N]
  double before_ = 0, open_before_ = 0;  ///< last transfer [N] and its open moment [N m]
  bool has_before_ = false, lifts_ = false;
};
}  // namespace wheel_rail_contact::core
