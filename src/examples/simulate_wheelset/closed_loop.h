// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "examples/simulate_wheelset/contact_source.h"
#include "examples/simulate_wheelset/motion_table.h"
#include "examples/simulate_wheelset/parameters.h"
#include "examples/simulate_wheelset/waves.h"

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

/// What happened in a run.
struct RunSummary
{
  int steps = 0;          ///< number of steps
  int held = 0;           ///< steps with the contact of an earlier one, because there was no usable result
  int saturated = 0;      ///< steps in which the creep force of a contact was at the friction limit
  int outside_table = 0;  ///< steps with a contact whose ratio of semi-axes is beyond Kalker's table
  Waves waves;            ///< of the last third of the run
  StepTimes times;        ///< wall times
};

/// Runs the loop: send pose and load, receive the contact, advance the motion by one step.
/// @param table rows of the steps; null: none
/// @throw std::runtime_error if the contact calculation cannot be reached, has no usable result in too many successive
/// steps (HeldContact), or the motion does not converge.
RunSummary runClosedLoop(const Parameters& parameters, ContactSource& source, MotionTable* table);
}  // namespace simulate_wheelset
