// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core
{
/// Prevents the search for the roll from oscillating between two contacts. Each pass gives the difference of the axle
/// heights calculated from the two wheels. This difference decreases with the roll. While it shrinks fast from pass to
/// pass, the rolls proposed from rigid contact are used. If it shrinks too slowly or oscillates, the secant of the
/// passes takes over. Its steps are halved when they change direction.
class RollSecant
{
 public:
  static constexpr double least_fall = 0.1;  ///< least credible decrease of the difference with the roll [m]

  /// Discards the previous passes.
  void reset() { *this = RollSecant(); }

  /// Lets the secant take over from the first pass, where rigid contact gives no prediction.
  /// @param roll  first roll to try [rad]
  /// @param fall  estimated decrease of the difference with the roll [m]
  void start(double roll, double fall)
  {
    reset();
    takes_over_ = true;
    last_roll_ = roll;
    fall_ = std::clamp(fall, least_fall, greatest_fall);
  }

  /// True if the last two passes had the same roll [rad] and nearly the same height difference [m]. The remaining
  /// errors of the planes then hardly change the difference.
  bool steady(double roll, double difference)
  {
    const bool same = roll == seen_roll_;
    const double change = std::abs(difference - seen_difference_);
    seen_roll_ = roll;
    seen_difference_ = difference;
    return same && change < steady_change * std::abs(difference);
  }

  /// Records the height difference [m] that a pass found at its roll [rad].
  void record(double roll, double difference)
  {
    const double fall = passes_ > 0 ? (last_difference_ - difference) / (roll - last_roll_) : fall_;
    fall_ = fall > least_fall && fall < greatest_fall ? fall : fall_;
    const bool oscillates = passes_ > 0 && difference * last_difference_ < 0;
    const bool slow = (oscillates || passes_ >= free_passes) && std::abs(difference) > 0.5 * std::abs(last_difference_);
    takes_over_ = takes_over_ || slow;
    last_step_ = passes_ > 0 ? roll - last_roll_ : 0;
    last_roll_ = roll;
    last_difference_ = difference;
    ++passes_;
  }

  /// True if the next roll is to be taken from roll().
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
  static constexpr double longest_first = 1e-3;  ///< limit of the first step after start() [rad]
  static constexpr double steady_change = 0.3;   ///< relative change of the difference at one roll [-]
  static constexpr double greatest_fall = 5.0;   ///< largest credible decrease of the difference with the roll [m]

  double fall_ = 1.5;  ///< decrease of the difference with the roll [m]; initially the distance of the wheels
  double last_roll_ = 0;
  double last_difference_ = 0;
  double last_step_ = 0;
  double seen_roll_ = std::numeric_limits<double>::quiet_NaN();  ///< roll of the last pass, recorded or not [rad]
  double seen_difference_ = 0;                                   ///< height difference of that pass [m]
  int passes_ = 0;
  bool takes_over_ = false;
};
}  // namespace wheel_rail_contact::core
