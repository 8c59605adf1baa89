// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Loads of both wheels that balance force and moment of the vehicle (WheelsetConfig::Balance::moments).
///
/// The unknown is the transfer t: half the load of the right wheel minus that of the left one. The open moment T + M_l
/// - M_r falls with t where the wheelset is stable; T is the moment of the vehicle, M those of the contacts, positive
/// if they lift their own wheel. It is zero at a transfer between the ones at which a wheel carries no load, or the
/// wheelset lifts a wheel. Newton's method starts with the lever arms of the contacts as the slope and continues with
/// secants; bisection takes over where a step leaves the bracket.
class LoadTransfer
{
 public:
  /// Begins a search.
  /// @param load    sum of both wheel loads [N], >= 0
  /// @param torque  moment T of the vehicle about the axle centre [N m]
  /// @param levers  sum of the lever arms of both wheels [m]. A lever arm is the moment of a contact, positive if it
  /// lifts its own wheel, over its load.
  /// @param lever_difference  lever arm of the left wheel minus that of the right one [m]
  void begin(double load, double torque, double levers, double lever_difference);

  /// Transfer t [N]: the wheels carry load/2 - t on the left and load/2 + t on the right.
  double transfer() const { return transfer_; }

  /// Result of a step of the search.
  enum class Step
  {
    moved,   ///< the next solution is required at transfer()
    closed,  ///< the moments are in balance, or a wheel lifts
    failed   ///< no balance was found
  };

  /// Forgets the bracket, because the next moments are those of other grids.
  void widen();
  /// Takes the solution at the transfer, and moves to the next one.
  /// @param open        open moment [N m]
  /// @param levers      sum of the lever arms [m]
  /// @param accuracy    smaller movements end the search [N]
  /// @param acceptable  largest open moment at its end [N m]. A larger one shows that the sign of an earlier moment was
  /// wrong, because its roll was only found roughly: the search begins again from here
  Step advance(double open, double levers, double accuracy, double acceptable);
  /// Moves half way back to the transfer before, because there is no solution at this one.
  Step retreat();
  /// True if a wheel carries no load and the moment stays open.
  bool lifts() const { return lifts_; }

 private:
  double within(double transfer) const;
  double next(double levers) const;
  void moveTo(double transfer);

  double half_load_ = 0;
  double transfer_ = 0;
  double least_ = 0, most_ = 0;          ///< bracket of the transfer [N]
  double open_ = 0;                      ///< open moment at the transfer [N m]
  double before_ = 0, open_before_ = 0;  ///< last transfer [N] and its open moment [N m]
  bool has_before_ = false, lifts_ = false;
  int corrections_ = 0;  ///< of brackets and steps since begin()
};
}  // namespace wheel_rail_contact::core
