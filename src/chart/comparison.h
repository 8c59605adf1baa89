// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "chart/method_run.h"

namespace wheel_rail_contact::core::chart
{
/// Extent of the measurement.
struct Plan
{
  int rounds = 3;              ///< number of rounds; each round runs every method once
  double slowest = 0.05;       ///< methods with a longer expected time are not run [s per result]
  bool sweeps = true;          ///< whether the longest times are measured
  GridSize truth{256, 512};    ///< grid of the reference solution, by conjugate gradients
  GridSize coarser{128, 256};  ///< the error of the reference solution is its difference from this grid
  int reach = longest_reach;   ///< steps of the messages to either side of the scene, 1 to longest_reach
};

/// Measurements of one method, either all from a cold start or all from the previous result.
struct Series
{
  enum class Status
  {
    solved,
    refused,       ///< no result, but a reason, at one or more positions
    other_wheels,  ///< other wheels than in the reference solution have a contact: the error is not defined
    not_run        ///< the expected time is too long
  };
  /// Error of one inspected result.
  struct Result
  {
    double error;     ///< largest of its Errors [-]
    double estimate;  ///< its own error estimate [-]
  };

  Status status = Status::solved;
  std::string reason;         ///< empty if solved
  std::vector<double> times;  ///< CPU time of the thread per result or failure [s]; with not_run the expected time
  /// CPU time of each state of the warm sweep, one for each round [s].
  std::vector<std::vector<double>> sweep_times;
  std::vector<Result> results;  ///< at all timed positions
  Errors errors;                ///< largest errors of these results
  Outcome outcome;              ///< last result

  /// Error estimate of the result with the largest error [-]; 0 without results.
  double estimate() const;
  /// Longest time of a state of the sweep, each the median of its rounds [s]; 0 without a sweep.
  double longest() const;
};

const char* toString(Series::Status status);

struct Entry
{
  Choice choice;
  Series cold, warm;
};

struct Result
{
  std::vector<Entry> entries;
  double truth_error = 0;  ///< error of the reference solution [-]
};

/// Runs all methods on a scene, in turns, so that disturbances affect all of them alike.
/// - Cold: each result after discarding the previous one.
/// - Warm: messages to and fro about the scene, one step apart. Errors are determined for all of them, each against the
///   reference solution at its own position. At a single position a coarse grid may be accurate by chance: the error
///   depends on the position of its cells on a narrow pressure lobe.
/// - Sweep: warm over the same path, each state timed alone, so that no spike hides in the mean of a path: at the
///   messages, and in wheelset scenes also in steps of a tenth. Slow methods are timed at the messages only.
///
/// @param progress  called `stepsOf(plan)` times
/// @throw std::runtime_error if the scene has no reference solution
Result compare(Scene& scene, const std::vector<Choice>& choices, const Plan& plan,
               const std::function<void()>& progress);

int stepsOf(const Plan& plan);
}  // namespace wheel_rail_contact::core::chart
