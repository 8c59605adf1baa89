// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "core/balance/bending_rail.h"
#include "core/balance/grid_levels.h"
#include "core/balance/load_search.h"
#include "core/balance/roll_secant.h"
#include "wheel_rail_contact/core/wheelset_result.h"
#include "wheel_rail_contact/core/wheelset_state.h"

namespace wheel_rail_contact::core
{
/// Vertical balance of both wheels of a wheelset, together with the deflection of the rails.
///
/// The unknowns are the roll and, with the model `compliance`, the displacements of both rail heads. One pass does the
/// following:
/// - It places the wheelset at the roll at which both wheels give the same axle height with the present penetrations.
///   This uses rigid contact only.
/// - It solves both wheels at this roll.
/// - It compares the axle heights of the two wheels, the deflections used with those that the forces cause, and the
///   planes with the pressure-weighted normals.
///
/// Passes are repeated until all of them agree. If height and roll are given and the rails bend by a table, the wheel
/// loads are unknown instead.
class WheelsetBalance
{
 public:
  /// Keeps references to `config` and `levels`, which must outlive this.
  WheelsetBalance(const ContactModelConfig& config, const GridLevels& levels);
  WheelsetBalance(const WheelsetBalance&) = delete;
  WheelsetBalance& operator=(const WheelsetBalance&) = delete;

  /// Solves a valid state, starting from the last result. If this fails, solves it from a cold start, and then from
  /// results next to it. If the status is not ok, reason() gives the reason.
  ContactStatus solve(const WheelsetState& state);

  /// One sentence; empty if the status is ok.
  std::string_view reason() const { return reason_; }
  /// Height of the axle centre, track frame [m].
  double height() const { return height_; }
  /// Roll, track frame [rad].
  double roll() const { return roll_; }
  /// Remaining roll error of the last pass [rad]. It is included in roll(), but not in the solutions of the wheels.
  double openRoll() const { return open_roll_; }
  /// Last solution of one wheel.
  const WheelContact& wheel(Side side) const { return wheel_[static_cast<std::size_t>(side)]; }
  /// False if the wheel carries no load.
  bool loaded(Side side) const { return loaded_[static_cast<std::size_t>(side)]; }
  /// Deflection and forces of one rail.
  const RailResult& rail(Side side) const { return rail_[static_cast<std::size_t>(side)].result(); }

  /// Discards the last result.
  void reset();

 private:
  ContactStatus search(const WheelsetState& state);
  ContactStatus searchAround(const WheelsetState& state);
  ContactStatus fail(ContactStatus status, std::string_view reason);
  ContactStatus failed(WheelStatus status);
  bool begin(const WheelsetState& state);
  bool place(bool first);
  WheelsetPose poseOf(Side side, double roll) const;
  bool touchBoth(double roll);
  bool touchFirst();
  bool findRoll(bool first);
  double heightDifference() const;
  double lever(Side side) const;
  double leverSum() const;
  WheelStatus solveWheel(Side side, const GridLevel& level);
  WheelStatus solveWheels(bool rough);
  double moveRails();
  double expectedLoad(Side side);
  bool heightsMeet();
  bool heightOnBendingRails() const;
  bool layoutFits(double slack);
  bool isLevel(double open_roll, double slack) const;
  bool isFar(double roll_change) const;
  void predictRoll(double moved);
  bool fineEnough();
  void chooseGrids();
  void tryClosedForm(Side side);
  void leaveClosedForms();
  void finish(double roll_change);

  const ContactModelConfig& config_;
  const GridLevels& levels_;
  std::array<WheelContact, 2> wheel_;
  std::array<BendingRail, 2> rail_;
  WheelsetState state_;
  std::array<double, 2> load_{};  ///< vertical wheel loads [N]
  std::array<bool, 2> loaded_{};
  std::array<double, 2> penetration_{};  ///< present penetrations [m]
  std::array<RigidTouch, 2> touch_;
  std::array<GridLevelChoice, 2> choice_;
  std::array<ErrorEstimate, 2> error_;
  SolveStatus normal_status_ = SolveStatus::converged;  ///< status of the last solution that failed
  RollSecant secant_;
  bool finds_loads_;  ///< the wheel loads are unknown, height and roll are given
  std::array<LoadSearch, 2> load_search_;
  double height_ = 0;
  double roll_ = 0;
  double open_roll_ = 0;
  bool warm_ = false;
  std::string_view reason_;
};
}  // namespace wheel_rail_contact::core
