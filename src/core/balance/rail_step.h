// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
/// Step limit that prevents a rail from oscillating between two contacts. A solution with the tread only moves the rail
/// inward, one with the flange only moves it outward; only in between are both in contact. Each displacement is limited
/// to a maximum. If the direction reverses, it is limited to half of the last one.
class RailStep
{
 public:
  /// Discards the previous steps.
  void reset() { *this = RailStep(); }

  /// Share of a displacement of the rail that is to be applied [-].
  /// @param slip     length of the displacement along the contact planes [m]
  /// @param lateral  its lateral part, whose sign gives the direction
  double share(double slip, double lateral)
  {
    const bool turns_back = lateral * last_ < 0;
    limit_ = turns_back ? 0.5 * std::abs(last_) : std::min(longest, growth * limit_);
    const double share = std::min(1.0, limit_ / slip);
    last_ = std::copysign(share * slip, lateral);
    return share;
  }

 private:
  static constexpr double longest = 0.4e-3;  ///< largest displacement along the contact planes in one pass [m]
  static constexpr double growth = 1.5;      ///< factor of the limit while the direction is unchanged [-]

  double limit_ = longest;
  double last_ = 0;  ///< last displacement, with the sign of its lateral part [m]
};
}  // namespace wheel_rail_contact::core
