// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>
#include <vector>

#include "core/balance/patch_result.h"

namespace wheel_rail_contact
{
/// One patch of a wheel.
struct PatchOutcome
{
  core::ContactMeasures measures;
  double approach = 0;  ///< from the first touch of the patch, along its normal [m]
  core::ErrorEstimate error;
};

/// Quantities of one wheel that the chart compares. Two patches close to one another may be one on a coarse grid, so
/// the chart does not compare single patches.
struct WheelOutcome
{
  int index = 0;            ///< of the wheel
  double max_pressure = 0;  ///< highest [Pa]
  double area = 0;          ///< of all patches [m²]
  double approach = 0;      ///< mean of the patches, weighted with their forces [m]
  double estimate = 0;      ///< estimated relative error, largest of the three quantities [-]
};

/// Combines the patches of a wheel. The estimate follows the same rule as that of the balance.
WheelOutcome combined(int index, const std::vector<PatchOutcome>& patches);

/// Result of one method in one state of a scene.
struct Outcome
{
  bool usable = false;
  std::string reason;                ///< reason of a failure; empty if usable
  core::GridSize grid;               ///< finest of the patches
  double estimate = 0;               ///< estimated relative error, largest of the wheels [-]
  std::vector<WheelOutcome> wheels;  ///< those with a contact

  /// Adds a wheel, if it has patches.
  void add(int index, const std::vector<PatchOutcome>& patches);
};

/// A method on the states of a scene. Its times do not contain those of the interpreter.
class TimedRun
{
 public:
  virtual ~TimedRun() = default;

  /// Solves a state, starting from the last result if there is one.
  virtual void solve(std::size_t state) = 0;
  /// The next result starts cold.
  virtual void reset() = 0;
  /// Outcome of the last result.
  virtual Outcome outcome() const = 0;

  /// Solves states in turn. Returns their mean CPU time of this thread, which other processes do not change [s].
  /// @param cold  each of them starts cold
  double time(const std::vector<std::size_t>& states, bool cold);
};

/// Adds runs of normal methods on gaps, and of creep methods. TimedRun is added before.
void bindTimedSolvers(pybind11::module& module);
}  // namespace wheel_rail_contact
