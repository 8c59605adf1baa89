// SPDX-License-Identifier: BSD-3-Clause
#include "core/friction/contact_friction.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/constants.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_speed = 0.01;  ///< below it there are no creep forces [m/s]
constexpr double largest_step = 1;    ///< of an extrapolation, over the friction [-]
constexpr int most_passes = 8;        ///< of balance and friction
/// Difference of friction and balance after all passes, over the force of a wheel, up to which a result is usable [-]:
/// friction may jump with the normal forces.
constexpr double largest_open = 0.02;
constexpr double change_per_tolerance = 0.1;  ///< by the last pass, over the force of a wheel
}  // namespace

void ContactFriction::reset()
{
  assumed_.setZero();
  next_.setZero();
  rolling_.reset();
  is_open_ = false;
}

bool ContactFriction::acts(const WheelsetState& state) const
{
  return isSet() && std::abs(state.motion.speed) >= least_speed;
}

ContactStatus ContactFriction::solve(const WheelsetState& state, WheelsetBalance& balance)
{
  has_last_ = false;
  double change = infinity, least = infinity;
  Friction best = Friction::Zero();
  ContactStatus status = ContactStatus::ok;
  for (int pass = 0; pass < most_passes && change > change_per_tolerance * config_.contact.tolerance; ++pass)
  {
    status = pass == 0 ? solveAssumed(state, balance) : solveAgain(state, balance);
    if (!isUsable(status))
    {
      return fail(status, balance.reason());
    }
    if (const std::string_view fault = rolling_.solve(state, balance); !fault.empty())
    {
      return fail(ContactStatus::not_converged, fault);
    }
    const Friction friction = found();
    change = changeTo(friction);
    best = change < least ? assumed_ : best;
    least = std::min(change, least);
    next_ = extrapolated(friction);
    if (pass == most_passes - 2 && change > least)  // friction jumps: the last pass is the best one again
    {
      next_ = best;
    }
  }
  is_open_ = change > change_per_tolerance * config_.contact.tolerance;
  if (change > largest_open)
  {
    return fail(ContactStatus::not_converged, "friction and the balance of the normal forces did not converge");
  }
  next_ = found_;
  reason_ = {};
  return status;
}

/// Solves the balance with the next friction on the same grids, so that passes converge.
ContactStatus ContactFriction::solveAgain(const WheelsetState& state, WheelsetBalance& balance)
{
  assumed_ = next_;
  bear(balance);
  const ContactStatus status = balance.solveOnSameGrids(withFriction(state));
  return isUsable(status) ? status : solveAssumed(state, balance);
}

/// Solves the balance with the next friction, or without if that fails.
ContactStatus ContactFriction::solveAssumed(const WheelsetState& state, WheelsetBalance& balance)
{
  assumed_ = next_;
  bear(balance);
  const ContactStatus status = balance.solve(withFriction(state));
  if (isUsable(status) || assumed_.isZero(0))
  {
    return status;
  }
  reset();
  has_last_ = false;
  bear(balance);
  return balance.solve(state);
}

ContactStatus ContactFriction::fail(ContactStatus status, std::string_view reason)
{
  reset();
  reason_ = reason;
  return status;
}

WheelsetState ContactFriction::withFriction(WheelsetState state) const
{
  const auto left = assumed_.segment<2>(begin(Side::left)), right = assumed_.segment<2>(begin(Side::right));
  state.force_z += left[0] + right[0];
  state.torque_x += config_.wheelset.balance == WheelsetConfig::Balance::moments
                        ? left[1] + right[1]
                        : config_.wheelset.halfBase() * (left[0] - right[0]);
  return state;
}

void ContactFriction::bear(WheelsetBalance& balance) const
{
  for (const Side side : sides)
  {
    balance.wheel(side).setFriction(assumed_.segment<3>(begin(side) + 2));
  }
}

ContactFriction::Friction ContactFriction::found() const
{
  Friction friction;
  // A given lateral force replaces that of the contact.
  const bool bends = config_.rail_bending.lateral_force == RailBendingConfig::LateralForce::contact;
  for (const Side side : sides)
  {
    const Wrench wheel = rolling_.onWheel(side);
    friction.segment<2>(begin(side)) << wheel.force.z(), wheel.moment.x();
    friction.segment<3>(begin(side) + 2) = rolling_.onRail(side, bends);
  }
  return friction;
}

/// Largest difference of the found friction from the assumed one over the normal force of its wheel [-]. That of a
/// wheel without load counts over the other one.
double ContactFriction::changeTo(const Friction& found) const
{
  const Sides<double> forces([&](Side side) { return rolling_.normalForce(side); });
  const Friction open = found - assumed_;
  double largest = 0;
  for (const Side side : sides)
  {
    const auto of = open.segment<of_side>(begin(side));
    const double force = forces[side] > 0 ? forces[side] : std::max(forces.left, forces.right);
    const double changed = std::hypot(of[0], of[1] / config_.wheelset.halfBase(), of.segment<2>(2).norm());
    largest = changed > 0 ? std::max(largest, force > 0 ? changed / force : infinity) : largest;
  }
  return largest;
}

/// Combination of the last two passes for which the difference of found and assumed friction would be least: Anderson's
/// with one earlier pass. With more of them it extrapolates too far where a wheel slides on its flange.
ContactFriction::Friction ContactFriction::extrapolated(const Friction& found)
{
  const Friction open = found - assumed_;
  const Friction turn = open - std::exchange(open_, open), step = found - std::exchange(found_, found);
  if (!std::exchange(has_last_, true))
  {
    return found;
  }
  const Friction next = found - turn.dot(open) / turn.squaredNorm() * step;
  return next.allFinite() && (next - found).norm() < largest_step * found.norm() ? next : found;
}
}  // namespace wheel_rail_contact::core
