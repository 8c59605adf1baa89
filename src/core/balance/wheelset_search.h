// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/balance/wheel_equilibrium.h"
#include "core/balance/wheel_loads.h"
#include "core/track/rail_along.h"
#include "core/track/root_bracket.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/sides.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Search of the height and the roll at which both wheels are in equilibrium on given grids.
///
/// At a given roll, each wheel has one height under its load (WheelEquilibrium). The roll is the one for which both
/// heights are equal. On rigid rails their difference falls as the roll grows while tan(left contact angle) + tan(right
/// contact angle) < distance of the contacts / rolling radius. Beyond that, several rolls may be in equilibrium; the
/// result is then one at which the difference falls.
///
/// With WheelsetConfig::Balance::moments, the transfer is unknown too: half the load of the right wheel minus that of
/// the left one. It is the one at which the moments about the axle centre are in balance: T + M_l - M_r = 0; T is the
/// moment of the vehicle, M those of the contacts, positive if they lift their own wheel. If a wheel carries no load
/// and the moment stays open, the wheelset lifts it.
///
/// One Newton step closes heights and moments together. What the height difference would be after the moments are
/// closed is a falling function of the roll, which RootBracket brackets.
class WheelsetSearch
{
 public:
  /// What the last solution was for.
  enum class Start
  {
    other_state,
    near,        ///< the same state on coarser grids, or one a short step before: its derivatives are kept
    other_grids  ///< the same state, on grids of the same size: the forces jump by the errors of both
  };

  /// Keeps references to `config` and `solver`, which must outlive this.
  WheelsetSearch(const ContactModelConfig& config, NormalSolver& solver);

  /// Forgets the last solutions. The next search starts at a roll [rad].
  void reset(double roll);
  /// Begins the search for a state: at the last roll and heights, moved as the state has, or cold after reset(). The
  /// wheels must be at their place on the line.
  /// @param keeps_grids  the search begins on the grids of the last one
  void begin(const WheelsetState& state, bool keeps_grids);
  /// False until the first begin() after a reset().
  bool isWarm() const { return warm_; }
  /// Has a wheel solved again, on other grids.
  void renew(Side side) { solved_[side].reset(); }
  /// Finds height and roll.
  WheelStatus solve(Start start);
  /// Solves at the height and the roll of the state.
  WheelStatus solveAtGivenHeight();

  WheelEquilibrium& wheel(Side side) { return wheels_[side]; }
  const WheelEquilibrium& wheel(Side side) const { return wheels_[side]; }
  double height() const { return z_; }         ///< height of the axle centre, track frame [m]
  double roll() const { return place_.roll; }  ///< roll, track frame [rad]
  const WheelsetState& state() const { return state_; }
  /// Largest opening of the gap of a wheel, over its overlap, by what is left of the balance [-].
  double open(Side side) const { return open_[side]; }
  /// True if the moments stay open, because the wheelset lifts a wheel.
  bool lifts() const { return lifts_; }

 private:
  /// A step of roll and loads.
  struct Step
  {
    double roll = 0;        ///< [rad]
    Sides<double> loads;    ///< at its end [N]
    double difference = 0;  ///< of the heights, were the moments closed [m]
    double slope = 0;       ///< of the difference over the roll [m/rad], < 0
  };
  /// Where the search is.
  struct Place
  {
    double roll = 0;        ///< [rad]
    Sides<double> loads;    ///< vertical wheel loads [N]
    Sides<double> heights;  ///< of the axle centre for each wheel [m]
    Sides<double> moments;  ///< of the contacts about the axle centre, positive if they lift their wheel [N m]
  };

  /// For what a wheel was solved.
  struct Solved
  {
    double roll = 0;  ///< [rad]
    double load = 0;  ///< [N]
  };

  double heightDifference() const;
  bool takesLoad();
  bool ends(Step& step, Start start, bool returning);
  Sides<double> loadsAfter(double roll) const;
  void follow(const WheelsetState& before);
  double sumOfRates(WheelEquilibrium::Output output, WheelEquilibrium::Input input) const;
  void move(const Step& step);
  double openingAt(Side side, double roll, double load) const;
  WheelStatus solveWheels(const KeptResult& kept, bool& any);
  bool closes(const Step& step, double share);
  bool isNarrow(double range) const;
  double uncertainty(const Step& step) const;
  void shorten(Step& step) const;
  Step newton() const;
  void retreat(const Place& earlier);

  const ContactModelConfig& config_;
  double accuracy_;       ///< largest opening by what is left of the balance, over the overlap [-]
  double greatest_turn_;  ///< of the roll in one step [rad]
  Sides<WheelEquilibrium> wheels_;
  WheelsetState state_;
  WheelLoads loads_;
  bool warm_ = false, keeps_grids_ = false;
  double start_roll_ = 0, z_ = 0;
  Place place_;
  Sides<std::optional<Solved>> solved_;  ///< for this state
  Sides<double> open_{};
  bool lifts_ = false;
};
}  // namespace wheel_rail_contact::core
