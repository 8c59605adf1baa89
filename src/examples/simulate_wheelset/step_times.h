// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace simulate_wheelset
{
/// Wall times of the steps of a run.
class StepTimes
{
 public:
  /// Adds a step [s].
  void add(double seconds) { seconds_.push_back(seconds); }
  /// Steps per second, median, 95 % and longest step in words; empty without a step.
  std::string text() const;

 private:
  std::vector<double> seconds_;
};
}  // namespace simulate_wheelset
