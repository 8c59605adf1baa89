// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::stability
{
/// A wheelset that moves from `begin` to `end` and back, each state from the result of the one before.
struct Sweep
{
  std::string name;
  ContactModelConfig config;
  double wheel_load;        ///< [N]
  double begin, end, step;  ///< lateral displacement [m]
  bool two_equilibria;      ///< expected in a part of the sweep

  int steps() const;
  double at(int index) const { return begin + index * step; }
};

/// One state of a sweep.
struct SweepState
{
  bool usable = false;
  double height = 0;        ///< of the axle centre [m]
  Sides<double> lateral{};  ///< force of each Side, outward positive [N]
  int solutions = 0;        ///< number of normal problems of both wheels
};

/// States of a sweep by index, on both ways.
struct SweepResult
{
  std::vector<SweepState> out, back;
};

SweepResult run(const Sweep& sweep);

/// Number of states without a result.
int refused(const SweepResult& result);
/// Largest number of normal problems of a state.
int mostSolutions(const SweepResult& result);
/// Largest difference of a lateral force [N] of two states.
double lateralStep(const SweepState& one, const SweepState& other);
/// Largest difference of a lateral force between neighbours on one way [N].
double largestStep(const std::vector<SweepState>& way);

/// Change of a lateral force, over the wheel load, beyond which the contact is at another place [-].
constexpr double jump = 0.1;

/// First and last index at which both ways differ by a jump; first > last if there is none.
struct Loop
{
  int first, last;
};
Loop loopOf(const Sweep& sweep, const SweepResult& result);

/// The sweeps of doc/stability.md.
std::vector<Sweep> sweeps();
}  // namespace wheel_rail_contact::core::stability
