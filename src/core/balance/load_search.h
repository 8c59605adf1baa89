// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
/// Finds the load under which a wheel lies at a given height on a rail that gives way. A rail on soft pads gives way
/// fifty times as far as wheel and rail flatten; so what one pass finds at a load is carried on to the next by the
/// secant, as long as that agrees with what the rail's compliance and Hertz's law let expect.
class LoadSearch
{
 public:
  /// Sets out from an expected load [N].
  void begin(double load)
  {
    *this = LoadSearch();
    load_ = load;
  }

  /// To be put on the wheel next [N].
  double load() const { return load_; }

  /// Takes in by how much the axle lies too high under load() [m], and how far it is expected to come down under a
  /// newton more [m/N].
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
  static constexpr double most_off = 5;     ///< of the secant from what is expected [-]
  static constexpr double most_change = 4;  ///< of the load from pass to pass [-]

  double load_ = 0;
  double last_load_ = 0;
  double last_high_ = 0;
  int passes_ = 0;
};
}  // namespace wheel_rail_contact::core
