// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/balance/grid_levels.h"
#include "core/balance/islands.h"
#include "core/balance/load_transfer.h"
#include "core/balance/wheel_equilibrium.h"
#include "core/track/rail_along.h"
#include "wheel_rail_contact/core/sides.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Both wheels of a wheelset on the surfaces of their rails: finds height, roll and the deflections of the rails for
/// given wheel loads, or the loads for a given height and roll.
///
/// At a given roll, each wheel has one height under its load (WheelEquilibrium). The roll is the one for which both
/// heights are equal. Their difference brackets it: it is positive at a low roll and negative at a high one. Newton's
/// method with the slopes of the heights finds it; bisection takes over where a step leaves the bracket. On rigid rails
/// the difference falls as the roll grows while tan(left contact angle) + tan(right contact angle) < distance of the
/// contacts / rolling radius. Beyond that, several rolls may be in equilibrium; the result is then one at which the
/// difference falls.
///
/// With WheelsetConfig::Balance::moments, the wheel loads are those for which the moments about the axle centre are in
/// balance (LoadTransfer).
class WheelsetBalance
{
 public:
  /// Keeps references to `config` and `levels`, which must outlive this.
  WheelsetBalance(const ContactModelConfig& config, const GridLevels& levels);

  /// The next solution starts cold, at a roll [rad].
  void reset(double roll = 0);

  /// Solves a valid state. The last result is the start; if no balance is found from there, a cold start follows. If
  /// the status is not ok, reason() gives the reason.
  ContactStatus solve(const WheelsetState& state);

  /// One sentence; empty if the status is ok.
  std::string_view reason() const { return reason_; }
  const ContactModelConfig& config() const { return config_; }
  /// Pose of the wheelset, with the solved (or given) height and roll, track axes.
  WheelsetPose pose() const { return {state_.y, z_, state_.yaw, roll_}; }
  double height() const { return z_; }   ///< height of the axle centre, track frame [m]
  double roll() const { return roll_; }  ///< roll, track frame [rad]
  /// A wheel on its rail.
  const WheelEquilibrium& wheel(Side side) const { return wheels_[side]; }
  WheelEquilibrium& wheel(Side side) { return wheels_[side]; }
  /// Separate contacts of a wheel.
  const Islands& islands(Side side) const { return islands_[side]; }
  /// Estimated errors of these contacts.
  const std::vector<ErrorEstimate>& errors(Side side) const { return errors_[side]; }
  /// Estimated relative error of the highest pressure, the whole area and the approach of a wheel, the largest of them
  /// [-].
  double wheelError(Side side) const { return wheel_errors_[side]; }
  /// Largest opening of the gap of a wheel, over its overlap, by what is left of the balance [-].
  double balanceError(Side side) const { return open_[side]; }
  /// True if the moments stay open, because the wheelset lifts a wheel (WheelsetConfig::Balance::moments).
  bool lifts() const { return balances_moments_ && transfer_.lifts(); }
  /// With the status too_deep: depth of the given height below that of first touch, of the wheel that is less deep [m].
  double depth() const { return depth_; }
  /// Number of normal problems of both wheels in the last call.
  int solutions() const { return solutions_; }

 private:
  ContactStatus solveOnce(const WheelsetState& state);
  void beginTransfer();
  double leverOf(Side side) const;
  void distribute(double sum, double transfer);
  WheelStatus balanceLoads();
  LoadTransfer::Step advanceTransfer(double sum);
  WheelStatus search();
  WheelStatus solveMovedWheels(bool keep_grids);
  WheelStatus solveAtGivenHeight();
  double depthOfHeight(WheelStatus status);
  void placeOnLine();
  double tilt(const WheelsetState& state) const { return tiltOf(state.rail_displacement, config_.wheelset.halfBase()); }
  void predict(const WheelsetState& before);
  bool isMoved(Side side) const;
  double openedBy(Side side, double roll) const;
  double updateSlopes();
  void turn(double roll);
  bool isNarrow(double range) const;
  bool closeDifference(double difference, double share);
  bool refine();
  bool requireOwnGrids();
  void setLevel(Side side, std::size_t level);
  double estimate(Side side);
  int count() const;
  ContactStatus fail(WheelStatus status);

  const ContactModelConfig& config_;
  const GridLevels& levels_;
  double accuracy_;  ///< largest opening by what is left of the balance, over the overlap [-]
  bool balances_moments_;
  double greatest_turn_;  ///< of the roll in one step [rad]
  Sides<WheelEquilibrium> wheels_;
  WheelsetState state_;
  LoadTransfer transfer_;
  Sides<double> loads_{};        ///< vertical wheel loads [N]
  Sides<double> heights_{};      ///< of the axle centre for each wheel [m]
  Sides<double> slopes_{};       ///< their change per roll [m/rad]
  Sides<double> solved_roll_{};  ///< roll of the last solutions [rad]
  Sides<bool> solved_{};         ///< for this state
  Sides<bool> unestimated_{};    ///< its errors are not estimated yet
  Sides<std::size_t> level_{};
  Sides<Islands> islands_;
  Sides<std::vector<ErrorEstimate>> errors_;
  Sides<double> wheel_errors_{};
  Sides<double> open_{};
  bool any_solved_ = false;  ///< in the last pass
  double z_ = 0, roll_ = 0, start_roll_ = 0;
  bool warm_ = false;
  double depth_ = 0;                 ///< see depth()
  bool own_grids_required_ = false;  ///< requireOwnGrids() was called on these levels
  int solutions_ = 0;
  std::string_view reason_;
};
}  // namespace wheel_rail_contact::core
