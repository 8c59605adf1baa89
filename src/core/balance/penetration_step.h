// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace wheel_rail_contact::core
{
/// Search for the penetration with which to build a gap: it should equal the penetration that the solution finds. If
/// the solutions oscillate about the penetrations used, as on an interval that grows onto the flange, the secant is
/// used.
class PenetrationStep
{
 public:
  static constexpr double longest = 1.5;  ///< largest factor of the penetration in one step [-]

  /// Penetration for the next gap, after a gap built for `built_for` was solved to `solved` [m].
  double next(double built_for, double solved)
  {
    const double error = solved - built_for;
    const bool oscillates = error * last_error_ < 0;
    const double step = oscillates ? error * (last_built_for_ - built_for) / (error - last_error_) : error;
    last_built_for_ = built_for;
    last_error_ = error;
    return std::clamp(built_for + step, built_for / longest, built_for * longest);
  }

 private:
  double last_built_for_ = 0;
  double last_error_ = 0;
};
}  // namespace wheel_rail_contact::core
