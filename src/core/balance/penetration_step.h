// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace wheel_rail_contact::core
{
/// Finds the descent that a gap has to be built for: the one that its solution finds. Where solutions swing about the
/// descents they were built for, as on a stretch that grows onto the flange with the descent, the secant is taken.
class PenetrationStep
{
 public:
  static constexpr double longest = 1.5;  ///< factor by which the descent may change in a step [-]

  /// Descent to build the next gap for, after one built for `built_for` was solved to `solved` [m].
  double next(double built_for, double solved)
  {
    const double error = solved - built_for;
    const bool swings = error * last_error_ < 0;
    const double step = swings ? error * (last_built_for_ - built_for) / (error - last_error_) : error;
    last_built_for_ = built_for;
    last_error_ = error;
    return std::clamp(built_for + step, built_for / longest, built_for * longest);
  }

 private:
  double last_built_for_ = 0;
  double last_error_ = 0;
};
}  // namespace wheel_rail_contact::core
