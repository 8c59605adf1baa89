// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/balance/wheelset_balance.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::chart
{
/// Quantities of one patch that the chart compares.
struct PatchOutcome
{
  int body = 0;             ///< index of the wheel
  double max_pressure = 0;  ///< [Pa]
  double area = 0;          ///< [m²]
  double approach = 0;      ///< from the first touch of the patch, along its normal [m]
};

/// Result of one method on one scene.
struct Outcome
{
  bool usable = false;
  std::string reason;   ///< reason of a failure; empty if usable
  GridSize grid;        ///< finest of the patches
  std::string solver;   ///< method that solved that patch
  double estimate = 0;  ///< estimated relative error, largest of the patches [-]
  std::vector<PatchOutcome> patches;
};

/// Relative errors [-], each the largest of all patches.
struct Errors
{
  double max_pressure = 0, area = 0, approach = 0;

  double largest() const;
};

/// Errors of `found` relative to `truth`. @return false if their patches differ
bool compare(const Outcome& found, const Outcome& truth, Errors& errors);

/// Larger value of each error.
Errors larger(const Errors& a, const Errors& b);

/// Outcome of a wheelset result.
Outcome outcomeOf(const WheelsetResult& result);

/// Same from the balance itself, which accepts finer grids than WheelsetContact.
Outcome outcomeOf(const WheelsetBalance& balance, ContactStatus status);
}  // namespace wheel_rail_contact::core::chart
