// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
/// Secant search for the load under which a wheel lies at a given height on a compliant rail. A rail on soft pads
/// deflects fifty times as far as wheel and rail flatten. The secant is used if it agrees with the value expected from
/// the rail's compliance and Hertz's law.
class LoadSearch
{
 public:
  /// Starts from an expected load [N].
  void begin(double load)
  {
    *this = LoadSearch();
    load_ = load;
  }

  /// Load for the next pass [N].
  double load() const { return load_; }

  /// Records the result of a pass under load().
  /// @param too_high  distance of the axle above the given height [m]
  /// @param expected  expected downward displacement per unit load [m/N]
  void record(double too_high, double expected)
  {
    const double seen = (last_high_ - too_high) / (load_ - last_load_);
    const bool believed = passes_ > 0 && seen > expected / most_off && seen < most_off * expected;
    last_load_ = load_;
    last_high_ = too_high;
    load_ = std::clamp(load_ + too_high / (believed ? seen : expected), load_ / most_change, most_change * load_);
    ++passes_;
  }

 private:
  static constexpr double most_off = 5;     ///< largest ratio of secant and expected value, either way [-]
  static constexpr double most_change = 4;  ///< largest factor of the load from pass to pass [-]

  double load_ = 0;
  double last_load_ = 0;
  double last_high_ = 0;
  int passes_ = 0;
};
}  // namespace wheel_rail_contact::core
