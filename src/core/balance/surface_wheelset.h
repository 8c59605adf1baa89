// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/balance/surface_contact.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/wheelset_state.h"

namespace wheel_rail_contact::core
{
/// Both wheels of a wheelset on rigid rails, on the surfaces of the rails: finds height and roll for given wheel loads.
///
/// At a given roll, each wheel has one height under its load (SurfaceContact). The roll is the one for which both
/// heights are equal. Each pass solves one normal problem for each wheel, and corrects heights and roll together by the
/// slopes of the heights (Newton's method). Their difference brackets the roll; bisection takes over where a step
/// leaves the bracket. The difference falls as the roll grows while tan(left contact angle) + tan(right contact angle)
/// < distance of the contacts / rolling radius. Beyond that, several rolls may be in balance; the search then ends at
/// the first one that it brackets.
class SurfaceWheelset
{
 public:
  /// Keeps references to `config` and `solver`, which must outlive the object.
  SurfaceWheelset(const ContactModelConfig& config, ConjugateGradients& solver, const SurfaceContactOptions& options);

  /// Solves a state. SolveStatus::invalid_problem if a wheel has no load or is beside its rail; `stalled` if the
  /// heights jump past one another at a roll.
  /// @param start  height and roll at which the search starts
  SolveStatus solve(const WheelsetState& state, double start_z, double start_roll);

  double z() const { return z_; }        ///< height of the axle centre [m]
  double roll() const { return roll_; }  ///< roll of the axle [rad]
  const SurfaceContact& wheel(Side side) const { return wheels_[static_cast<std::size_t>(side)]; }
  /// Number of normal problems of both wheels in the last call.
  int solutions() const { return solutions_; }

 private:
  SolveStatus pass(const WheelsetState& state);

  const ContactModelConfig& config_;
  std::array<SurfaceContact, 2> wheels_;
  std::array<double, 2> heights_{};  ///< of the axle centre for each wheel [m]
  std::array<double, 2> slopes_{};   ///< their change per roll [m/rad]
  double z_ = 0, roll_ = 0;
  int solutions_ = 0;
};
}  // namespace wheel_rail_contact::core
