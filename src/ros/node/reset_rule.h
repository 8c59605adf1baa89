// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace wheel_rail_contact
{
/// Tells at which inputs an evaluator forgets the answers before, and starts cold.
///
/// An answer depends, within the tolerance, on the one it was started from. So that a live node and a replay agree to
/// the last bit, wherever either begins and however many threads share the work, both start anew by one rule that knows
/// the stamps only: at every whole second, where time does not rise, and after `most_results` at the latest. The inputs
/// between two fresh starts are called a slice.
class ResetRule
{
 public:
  static constexpr int most_results = 200;  ///< in a slice

  /// True if there is a fresh start between inputs of these stamps, however many answers were before.
  static bool isSeam(const ros::Time& before, const ros::Time& stamp)
  {
    return stamp.sec != before.sec || stamp <= before;
  }

  /// Takes the stamps of the inputs in order.
  bool resets(const ros::Time& stamp)
  {
    const bool anew = count_ == 0 || count_ == most_results || isSeam(last_, stamp);
    last_ = stamp;
    count_ = anew ? 1 : count_ + 1;
    return anew;
  }

 private:
  ros::Time last_;
  int count_ = 0;  ///< inputs since the last fresh start
};
}  // namespace wheel_rail_contact
