// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/balance/wheelset_balance.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::chart
{
/// One patch of a wheel.
struct PatchOutcome
{
  double force = 0;         ///< [N]
  double max_pressure = 0;  ///< [Pa]
  double area = 0;          ///< [m²]
  double approach = 0;      ///< from the first touch of the patch, along its normal [m]
  ErrorEstimate error;
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

/// Result of one method on one scene.
struct Outcome
{
  bool usable = false;
  std::string reason;                ///< reason of a failure; empty if usable
  GridSize grid;                     ///< finest of the patches
  double estimate = 0;               ///< estimated relative error, largest of the wheels [-]
  std::vector<WheelOutcome> wheels;  ///< those with a contact

  /// Adds a wheel, if it has patches.
  void add(int index, const std::vector<PatchOutcome>& patches);
};

/// Relative errors [-], each the largest of all wheels.
struct Errors
{
  double max_pressure = 0, area = 0, approach = 0;

  double largest() const;
};

/// Errors of `found` relative to `truth`. @return false if other wheels have a contact
bool compare(const Outcome& found, const Outcome& truth, Errors& errors);

/// Larger value of each error.
Errors larger(const Errors& a, const Errors& b);

/// Outcome of a wheelset result.
Outcome outcomeOf(const WheelsetResult& result);

/// Same from the balance itself, which accepts finer grids than WheelsetContact.
Outcome outcomeOf(const WheelsetBalance& balance, ContactStatus status);
}  // namespace wheel_rail_contact::core::chart
