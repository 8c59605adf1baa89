// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/friction/rolling_wheelset.h"

namespace wheel_rail_contact::core
{
/// Balance of a wheelset with the friction of its contacts.
///
/// Friction depends on the normal forces, and these on friction, which bends the rails and carries load. The balance is
/// repeated with an extrapolation of the passes (Anderson 1965, J. ACM 12): where a wheel slides on its flange,
/// friction carries nearly the whole load, and the forces of successive passes alternate. It begins with the friction
/// of the last state.
class ContactFriction
{
 public:
  /// Keeps a reference to `config`, which must outlive this.
  explicit ContactFriction(const ContactModelConfig& config) : config_(config), rolling_(config) {}

  /// True if a method is set.
  bool isSet() const { return config_.creep.method != CreepMethod::none; }
  /// True if there are creep forces at this speed.
  bool acts(const WheelsetState& state) const;
  /// The next balance begins without friction.
  void reset();

  /// Solves a valid state. If the status is not usable, reason() gives the reason.
  ContactStatus solve(const WheelsetState& state, WheelsetBalance& balance);
  std::string_view reason() const { return reason_; }
  /// True if friction jumps: it differs from that of the balance by more than the tolerance, but by less than 2 %.
  bool isOpen() const { return is_open_; }

  /// Loads that the normal forces alone balance: those of the state with the friction assumed by the balance.
  WheelsetState withFriction(WheelsetState state) const;
  /// Sets the friction assumed on the rails of a balance.
  void bear(WheelsetBalance& balance) const;
  /// Friction of the last solve().
  RollingWheelset& rolling() { return rolling_; }
  /// Adds friction to the result of solve(), see RollingWheelset.
  void addTo(const WheelsetBalance& balance, WheelsetResult& result) const { rolling_.addTo(balance, result); }

 private:
  /// Friction on each wheel and rail: upward force on the wheel [N], its moment about the axle centre about x of the
  /// track [N m], and RollingWheelset::onRail(); of the left side, then of the right one.
  static constexpr int of_side = 5;
  using Friction = Eigen::Matrix<double, 2 * of_side, 1>;

  static constexpr int begin(Side side) { return of_side * static_cast<int>(side); }
  ContactStatus solveAgain(const WheelsetState& state, WheelsetBalance& balance);
  ContactStatus solveAssumed(const WheelsetState& state, WheelsetBalance& balance);
  ContactStatus fail(ContactStatus status, std::string_view reason);
  Friction found() const;
  double changeTo(const Friction& found) const;
  Friction extrapolated(const Friction& found);

  const ContactModelConfig& config_;
  RollingWheelset rolling_;
  Friction assumed_ = Friction::Zero();                          ///< of the balance
  Friction next_ = Friction::Zero();                             ///< of the next balance
  Friction found_ = Friction::Zero(), open_ = Friction::Zero();  ///< of the last pass; difference from the one assumed
  bool has_last_ = false;                                        ///< found_ and open_ are those of this state
  bool is_open_ = false;
  std::string_view reason_;
};
}  // namespace wheel_rail_contact::core
