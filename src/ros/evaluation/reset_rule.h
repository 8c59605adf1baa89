// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace wheel_rail_contact
{
/// Determines the inputs at which an evaluator resets its warm start.
///
/// A result depends, within the tolerance, on the previous one, from which it is started. Live node and replay must
/// give identical results, wherever they begin and whatever the number of threads. Both therefore apply one rule, which
/// depends only on the stamps. The warm start is reset at every whole second, where a stamp decreases, and after
/// `slice_capacity` results. A repeated stamp causes no reset. The inputs between two resets are called a slice.
class ResetRule
{
 public:
  static constexpr int slice_capacity = 200;  ///< largest number of inputs in a slice

  /// True if these successive stamps cause a reset, whatever the number of inputs in the slice.
  static bool isBoundary(const ros::Time& before, const ros::Time& stamp)
  {
    return stamp.sec != before.sec || stamp < before;
  }

  /// Adds the stamp of the next input. @return true if the warm start is reset before this input.
  bool resets(const ros::Time& stamp)
  {
    const bool is_first = count_ == 0 || count_ == slice_capacity || isBoundary(last_, stamp);
    last_ = stamp;
    count_ = is_first ? 1 : count_ + 1;
    return is_first;
  }

 private:
  ros::Time last_;
  int count_ = 0;  ///< number of inputs in the slice
};
}  // namespace wheel_rail_contact
