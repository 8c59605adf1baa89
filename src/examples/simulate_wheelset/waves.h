// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "examples/simulate_wheelset/wheelset_forces.h"

namespace simulate_wheelset
{
/// Means over the whole waves of a run: between the first and the last upward zero crossing of the lateral
/// displacement.
class Waves
{
 public:
  /// Adds a step.
  /// @param distance place along the track [m]
  /// @param y        lateral displacement [m]
  void add(double distance, double y, const RailForces& forces);

  /// Number of whole waves.
  int count() const { return count_; }
  /// Mean wavelength [m]; 0 without a whole wave.
  double wavelength() const;
  /// Largest lateral displacement of all steps, to either side [m].
  double largestY() const { return largest_y_; }
  /// Mean force that resists the running, backward positive [N]; 0 without a whole wave.
  double drag() const;
  /// Mean power of the friction [W]; 0 without a whole wave.
  double frictionPower() const;
  /// All of this in words.
  /// @param speed running speed [m/s]
  std::string text(double speed) const;

 private:
  /// Sums over steps.
  struct Sums
  {
    int steps = 0;
    double drag = 0, friction_power = 0;
  };

  int count_ = 0;
  double largest_y_ = 0;
  std::optional<double> first_crossing_;  ///< [m]
  double last_crossing_ = 0;              ///< [m]
  Sums whole_, begun_;                    ///< of the whole waves, and from the first crossing on
  bool has_last_ = false;
  double last_distance_ = 0, last_y_ = 0;
};
}  // namespace simulate_wheelset
