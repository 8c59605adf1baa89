// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core
{
/// Keeps the search for the roll from swinging between two contacts. Each pass gives the difference of the axle's
/// heights as seen from either side; it falls with the roll. While it shrinks fast, the rolls proposed from rigid touch
/// are taken; once it does not, or turns back, the secant of the passes themselves takes over, with steps that are
/// halved when they turn back.
class RollSecant
{
 public:
  static constexpr double least_fall = 0.1;  ///< of the difference with the roll, to be believed [m]

  /// Forgets the passes before.
  void reset() { *this = RollSecant(); }

  /// Takes over from the start, where rigid touch tells nothing: with the first roll to try [rad] and an estimate of
  /// how the difference falls with it [m].
  void start(double roll, double fall)
  {
    reset();
    takes_over_ = true;
    last_roll_ = roll;
    fall_ = std::clamp(fall, least_fall, greatest_fall);
  }

  /// True if the last two passes were at one roll [rad] and found about the same height difference [m]: planes that do
  /// not fit yet hardly change it any more.
  bool steady(double roll, double difference)
  {
    const bool same = roll == seen_roll_;
    const double change = std::abs(difference - seen_difference_);
    seen_roll_ = roll;
    seen_difference_ = difference;
    return same && change < steady_change * std::abs(difference);
  }

  /// Takes in the height difference [m] that a pass found at its roll [rad].
  void record(double roll, double difference)
  {
    const double fall = passes_ > 0 ? (last_difference_ - difference) / (roll - last_roll_) : fall_;
    fall_ = fall > least_fall && fall < greatest_fall ? fall : fall_;
    const bool swings = passes_ > 0 && difference * last_difference_ < 0;
    const bool slow = (swings || passes_ >= free_passes) && std::abs(difference) > 0.5 * std::abs(last_difference_);
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
    const double longest = last_step_ != 0 ? (turns_back ? 0.5 : 2.0) * std::abs(last_step_) : longest_first;
    return last_roll_ + std::clamp(step, -longest, longest);
  }

 private:
  static constexpr int free_passes = 3;          ///< passes before the secant may take over
  static constexpr double longest_first = 1e-3;  ///< of the steps, after start() [rad]
  static constexpr double steady_change = 0.3;   ///< of the difference at one roll, relative [-]
  static constexpr double greatest_fall = 5.0;   ///< of the difference with the roll, to be believed [m]

  double fall_ = 1.5;  ///< of the difference with the roll [m]; to start with, the distance of the wheels
  double last_roll_ = 0;
  double last_difference_ = 0;
  double last_step_ = 0;
  double seen_roll_ = std::numeric_limits<double>::quiet_NaN();  ///< of the last pass, recorded or not [rad]
  double seen_difference_ = 0;                                   ///< likewise [m]
  int passes_ = 0;
  bool takes_over_ = false;
};
}  // namespace wheel_rail_contact::core
