// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "chart/method_run.h"

namespace wheel_rail_contact::core::chart
{
/// How much is measured.
struct Plan
{
  int rounds = 3;              ///< in each of which every contender has its turn
  double slowest = 0.05;       ///< what is expected to take longer is not run [s an answer]
  GridSize truth{256, 512};    ///< errors are against conjugate gradients on this grid
  GridSize coarser{128, 256};  ///< the truth's own error is its difference from this one
  int reach = longest_reach;   ///< steps that messages go to either side of the scene, 1 to longest_reach
};

/// What was measured of one contender, all from cold or all from the answer before.
struct Series
{
  enum class Status
  {
    evaluated,
    refused,        ///< the method or the chain gave a reason instead of an answer, at one of the places at least
    other_patches,  ///< an answer has not the patches of the truth: no error can be given
    not_run         ///< expected to take too long
  };
  /// What is off of one answer that was looked at.
  struct Result
  {
    double error;     ///< largest of its Errors [-]
    double estimate;  ///< its own [-]
  };

  Status status = Status::evaluated;
  std::string reason;           ///< empty if answered
  std::vector<double> times;    ///< of an answer or a refusal [s], CPU time of the thread; of not_run: as expected
  std::vector<Result> results;  ///< at all of the places that were timed
  Errors errors;                ///< largest seen of them
  Outcome outcome;              ///< last seen

  /// The answer's own, where its error was largest [-]; 0 without answers.
  double estimate() const;
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
  double truth_error = 0;  ///< the truth's own [-]
};

/// Runs all contenders on a scene, in turns, so that a disturbance hits all alike. From cold: each answer after
/// forgetting the one before. Warm: messages to and fro about the scene, one step apart; errors are those of all of
/// them, each against the truth at its own place, for at a single place a coarse grid may be right by luck: how its
/// cells lie on a narrow lobe of the pressure decides.
/// @param progress  called `stepsOf(plan)` times
/// @throw std::runtime_error if the scene has no truth
Result compare(Scene& scene, const std::vector<Choice>& choices, const Plan& plan,
               const std::function<void()>& progress);

int stepsOf(const Plan& plan);
}  // namespace wheel_rail_contact::core::chart
