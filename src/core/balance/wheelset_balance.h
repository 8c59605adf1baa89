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
/// Vertical balance of both wheels of a wheelset, together with the rails' deflection.
///
/// Unknown are the roll and, with model compliance, the displacement of both rail heads. One pass places the wheelset
/// at the roll that lets both axle ends agree with the descents known so far (rigid touch only, cheap), solves both
/// wheels there, and compares: heights of the axle from either side, deflections used and deflections due, planes used
/// and pressure-weighted normals. Passes go on until all agree. Where height and roll are given and rails bend by a
/// table, the wheel loads are unknown instead.
class WheelsetBalance
{
 public:
  /// Refers to `config` and `ladder`, which must outlive it.
  WheelsetBalance(const ContactModelConfig& config, const GridLevels& levels);
  WheelsetBalance(const WheelsetBalance&) = delete;
  WheelsetBalance& operator=(const WheelsetBalance&) = delete;

  /// Solves a valid state, from the last answer; if that does not get there, from cold, and then from beside it. The
  /// reason stands in reason() where the status is not ok.
  ContactStatus solve(const WheelsetState& state);

  /// One sentence; empty where the status is ok.
  std::string_view reason() const { return reason_; }
  /// Axle centre, track frame [m].
  double height() const { return height_; }
  /// Track frame [rad].
  double roll() const { return roll_; }
  /// What the last pass left open of the roll [rad]: roll() contains it, the wheels as last solved do not.
  double openRoll() const { return open_roll_; }
  /// One wheel as last solved.
  const WheelContact& wheel(Side side) const { return wheel_[static_cast<std::size_t>(side)]; }
  /// False where the wheel carries nothing.
  bool loaded(Side side) const { return loaded_[static_cast<std::size_t>(side)]; }
  /// One rail's deflection and forces.
  const RailResult& rail(Side side) const { return rail_[static_cast<std::size_t>(side)].result(); }

  /// Forgets the last answer.
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
  void foresee(double moved);
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
  std::array<double, 2> penetration_{};  ///< known so far [m]
  std::array<RigidTouch, 2> touch_;
  std::array<GridLevelChoice, 2> choice_;
  std::array<ErrorEstimate, 2> error_;
  SolveStatus normal_status_ = SolveStatus::converged;  ///< of the last solution that failed
  RollSecant secant_;
  bool finds_loads_;  ///< under which the wheels lie at the height and roll given
  std::array<LoadSearch, 2> load_search_;
  double height_ = 0;
  double roll_ = 0;
  double open_roll_ = 0;
  bool warm_ = false;
  std::string_view reason_;
};
}  // namespace wheel_rail_contact::core
