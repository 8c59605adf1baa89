// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/balance/wheelset_balance.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::chart
{
/// What the chart compares of one patch.
struct PatchOutcome
{
  int body = 0;             ///< wheel it belongs to
  double max_pressure = 0;  ///< [Pa]
  double area = 0;          ///< [m²]
  double approach = 0;      ///< from the patch's first touch on, along its normal [m]
};

/// One answer to one scene.
struct Outcome
{
  bool usable = false;
  std::string reason;   ///< why not, empty if usable
  GridSize grid;        ///< finest of the patches
  std::string solver;   ///< method that solved that patch
  double estimate = 0;  ///< of the relative error, largest of the patches [-]
  std::vector<PatchOutcome> patches;
};

/// Relative errors [-], each the largest of all patches.
struct Errors
{
  double max_pressure = 0, area = 0, approach = 0;

  double largest() const;
};

/// False if the two do not hold the same patches.
bool compare(const Outcome& found, const Outcome& truth, Errors& errors);

/// The larger of each.
Errors larger(const Errors& a, const Errors& b);

Outcome outcomeOf(const WheelsetResult& result);

/// The same from the balance itself, which takes finer grids than a user may ask for.
Outcome outcomeOf(const WheelsetBalance& balance, ContactStatus status);
}  // namespace wheel_rail_contact::core::chart
