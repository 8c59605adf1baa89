// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/balance/grid_levels.h"
#include "core/balance/wheelset_search.h"
#include "core/normal/estimate/islands.h"
#include "wheel_rail_contact/core/sides.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Both wheels of a wheelset on the surfaces of their rails: finds height, roll and the deflections of the rails for
/// given wheel loads, or the loads for a given height and roll (WheelsetSearch), on grids that are as fine as the
/// tolerance requires (GridLevels).
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

  /// Solves a state that hardly differs from the last one, which has a usable status, on the same grids: results on
  /// other grids differ by the errors of both.
  ContactStatus solveOnSameGrids(const WheelsetState& state);

  /// One sentence; empty if the status is ok.
  std::string_view reason() const { return reason_; }
  const ContactModelConfig& config() const { return config_; }
  /// Pose of the wheelset, with the solved (or given) height and roll, track axes.
  WheelsetPose pose() const { return {search_.state().y, height(), search_.state().yaw, roll()}; }
  double height() const { return search_.height(); }  ///< height of the axle centre, track frame [m]
  double roll() const { return search_.roll(); }      ///< roll, track frame [rad]
  /// A wheel on its rail.
  const WheelEquilibrium& wheel(Side side) const { return search_.wheel(side); }
  WheelEquilibrium& wheel(Side side) { return search_.wheel(side); }
  /// Separate contacts of a wheel.
  const Islands& islands(Side side) const { return islands_[side]; }
  /// Estimated errors of these contacts.
  const std::vector<ErrorEstimate>& errors(Side side) const { return errors_[side]; }
  /// Estimated relative error of the highest pressure, the whole area and the approach of a wheel, the largest of them
  /// [-].
  double wheelError(Side side) const { return wheel_errors_[side]; }
  /// Largest opening of the gap of a wheel, over its overlap, by what is left of the balance [-].
  double balanceError(Side side) const { return search_.open(side); }
  /// True if the moments stay open, because the wheelset lifts a wheel (WheelsetConfig::Balance::moments).
  bool lifts() const { return search_.lifts(); }
  /// With the status too_deep: depth of the given height below that of first touch, of the wheel that is less deep [m].
  double depth() const { return depth_; }
  /// Number of normal problems of both wheels in the last call.
  int solutions() const { return solutions_; }

 private:
  ContactStatus solveOnce(const WheelsetState& state, std::size_t first_level = 0);
  ContactStatus statusOf(WheelStatus status);
  ContactStatus solveAlongPath(const WheelsetState& state);
  ContactStatus walk(const WheelsetState& state, double way, std::size_t first_level, double share, double& reached);
  WheelsetState placeOnLine(WheelsetState state);
  bool continues(WheelsetSearch::Start& start);
  bool refine();
  bool renewForeignGrids();
  double depthOfHeight(WheelStatus status);
  double estimate(Side side);
  void measure(Side side);
  int count() const;
  ContactStatus fail(WheelStatus status);
  ContactStatus discard(ContactStatus status, std::string_view reason);

  const ContactModelConfig& config_;
  const GridLevels& levels_;
  WheelsetSearch search_;
  Sides<std::size_t> level_{};
  Sides<int> estimated_{};  ///< number of solutions whose errors were estimated
  Sides<Islands> islands_;
  Sides<std::vector<ErrorEstimate>> errors_;
  Sides<double> wheel_errors_{};
  double depth_ = 0;  ///< see depth()
  int solutions_ = 0;
  std::string_view reason_;
};
}  // namespace wheel_rail_contact::core
