// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "wheel_rail_contact/balance/fixed_point.h"
#include "wheel_rail_contact/balance/method_ladder.h"
#include "wheel_rail_contact/balance/rail_step.h"
#include "wheel_rail_contact/balance/roll_secant.h"
#include "wheel_rail_contact/balance/wheel_contact.h"
#include "wheel_rail_contact/balance/wheelset_state.h"

namespace wheel_rail_contact
{
/// Vertical balance of both wheels of a wheelset, together with the rails' deflection.
///
/// Unknown are the roll and, with model compliance, the displacement of both rail heads. One pass places the wheelset
/// at the roll that lets both axle ends agree with the descents known so far (rigid touch only, cheap), solves both
/// wheels there, and compares: heights of the axle from either side, deflections used and deflections due, planes used
/// and pressure-weighted normals. Passes go on until all agree.
///
/// Where the contact's own forces bend the rails and the normal method can solve a support that yields, the deflection
/// comes out of each normal solution, at rails set to what the pass before found; passes go on until what the gap knows
/// to first order only, the rail's way along the contact plane, is short enough. Otherwise deflections due and used are
/// brought together by Anderson's mixing.
class WheelsetBalance
{
 public:
  /// Refers to `config` and `ladder`, which must outlive it.
  WheelsetBalance(const ContactModelConfig& config, const MethodLadder& ladder);

  /// Solves a valid state, from the last answer; if that does not get there, from cold. The reason stands in reason()
  /// where the status is not ok.
  ContactStatus solve(const WheelsetState& state);

  std::string_view reason() const { return reason_; }
  /// Axle centre, track frame [m].
  double height() const { return height_; }
  /// Track frame [rad].
  double roll() const { return roll_; }
  const WheelContact& wheel(Side side) const { return wheel_[static_cast<std::size_t>(side)]; }
  /// False where the wheel carries nothing.
  bool loaded(Side side) const { return loaded_[static_cast<std::size_t>(side)]; }
  const RailResult& rail(Side side) const { return rail_[static_cast<std::size_t>(side)]; }

  void reset();

 private:
  ContactStatus search(const WheelsetState& state);
  ContactStatus fail(ContactStatus status, std::string_view reason);
  ContactStatus failed(WheelStatus status);
  void setRails();
  bool letFlangesDown();
  bool begin(const WheelsetState& state);
  bool place();
  bool touchBoth(double roll);
  bool findRoll();
  double heightDifference() const;
  double lever(Side side) const;
  double leverSum() const;
  WheelStatus solveWheels(bool rough);
  void setRail(Side side, const RailDeflection& deflection);
  RailForce takeForce(Side side);
  double moveRails();
  double slipOver(Side side) const;
  double followContact(Side side);
  double mixDeflection(Side side, const RailForce& force);
  bool layoutFits(double slack);
  bool fineEnough();
  void chooseGrids();
  void finish(double roll_change);

  const ContactModelConfig& config_;
  const MethodLadder& ladder_;
  std::array<WheelContact, 2> wheel_;
  PlacedRail undeflected_;
  bool bends_;       ///< rails by the table
  Support support_;  ///< rails in the normal solution; yields only where deflection is solved there
  WheelsetState state_;
  std::array<double, 2> load_{};  ///< vertical wheel loads [N]
  std::array<bool, 2> loaded_{};
  std::array<double, 2> descent_{};  ///< known so far [m]
  std::array<RigidTouch, 2> touch_;
  std::array<RungChoice, 2> choice_;
  std::array<double, 2> error_{};                       ///< estimated, relative [-]
  SolveStatus normal_status_ = SolveStatus::converged;  ///< of the last solution that failed
  std::array<RailResult, 2> rail_;
  std::array<FixedPoint<3>, 2> coupling_;
  std::array<RailStep, 2> step_;
  RollSecant secant_;
  double height_ = 0;
  double roll_ = 0;
  bool warm_ = false;
  std::string_view reason_;
};
}  // namespace wheel_rail_contact
