// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
/// Keeps the search for the roll from swinging between two contacts. Each pass gives the difference of the axle's
/// heights as seen from either side; it falls with the roll. While it shrinks fast, the rolls proposed from rigid touch
/// are taken; once it does not, the secant of the passes themselves takes over, with steps that are halved when they
/// turn back.
class RollSecant
{
 public:
  void reset() { *this = RollSecant(); }

  /// Takes in the height difference [m] that a pass found at its roll [rad].
  void record(double roll, double difference)
  {
    const double fall = passes_ > 0 ? (last_difference_ - difference) / (roll - last_roll_) : fall_;
    fall_ = fall > least_fall && fall < greatest_fall ? fall : fall_;
    const bool slow = passes_ >= free_passes && std::abs(difference) > 0.5 * std::abs(last_difference_);
    takes_over_ = takes_over_ || slow;
    last_step_ = passes_ > 0 ? roll - last_roll_ : 0;
    last_roll_ = roll;
    last_difference_ = difference;
    ++passes_;
  }

  /// True if the next roll is to be taken from here.
  bool takesOver() const { return takes_over_; }

  /// Roll to try [rad].
  double roll() const
  {
    const double step = last_difference_ / fall_;
    const bool turns_back = step * last_step_ < 0;
    const double longest = (turns_back ? 0.5 : 2.0) * std::abs(last_step_);
    return last_roll_ + std::clamp(step, -longest, longest);
  }

 private:
  static constexpr int free_passes = 3;         ///< passes before the secant may take over
  static constexpr double least_fall = 0.1;     ///< of the difference with the roll, to be believed [m]
  static constexpr double greatest_fall = 5.0;  ///< likewise [m]

  double fall_ = 1.5;  ///< of the difference with the roll [m]; to start with, the distance of the wheels
  double last_roll_ = 0;
  double last_difference_ = 0;
  double last_step_ = 0;
  int passes_ = 0;
  bool takes_over_ = false;
};
}  // namespace wheel_rail_contact
