// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
/// Keeps a rail from swinging between two contacts: a solution that sees the tread only wants it inward, one that sees
/// the flange only wants it outward, and only between them both are seen. Ways are cut to a longest one, and where they
/// turn back to half of the last.
class RailStep
{
 public:
  /// Forgets the steps before.
  void reset() { *this = RailStep(); }

  /// Share of the wanted way that the rail is to be moved by [-]. `slip`: length of the way along the contact planes
  /// [m], `lateral`: its lateral part, for its sense.
  double share(double slip, double lateral)
  {
    const bool turns_back = lateral * last_ < 0;
    limit_ = turns_back ? 0.5 * std::abs(last_) : std::min(longest, growth * limit_);
    const double share = std::min(1.0, limit_ / slip);
    last_ = std::copysign(share * slip, lateral);
    return share;
  }

 private:
  static constexpr double longest = 0.4e-3;  ///< by which a rail may be moved along the contact planes at once [m]
  static constexpr double growth = 1.5;      ///< of the limit where ways go on in one sense [-]

  double limit_ = longest;
  double last_ = 0;  ///< way moved last, with the sign of its lateral part [m]
};
}  // namespace wheel_rail_contact::core
