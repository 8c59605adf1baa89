// SPDX-License-Identifier: BSD-3-Clause
#include "chart/outcome.h"

#include <algorithm>
#include <cmath>

#include "core/balance/patch_result.h"
#include "core/balance/wheel_error.h"

namespace wheel_rail_contact::core::chart
{
namespace
{
void takeFiner(const GridSize& grid, GridSize& finest)
{
  if (grid.along * grid.across > finest.along * finest.across)
  {
    finest = grid;
  }
}

/// A result has one estimate for each patch, which holds for all of its quantities.
PatchOutcome outcomeOf(const PatchResult& patch)
{
  const double error = patch.error_estimate;
  return {patch.normal_force, patch.max_pressure, patch.area, patch.approach, {error, error, error}};
}

void addWheels(const std::vector<PatchResult>& patches, Outcome& outcome)
{
  for (const Side side : {Side::left, Side::right})
  {
    std::vector<PatchOutcome> own;
    for (const PatchResult& patch : patches)
    {
      if (patch.side == side)
      {
        takeFiner({patch.grid.nx, patch.grid.ny}, outcome.grid);
        own.push_back(outcomeOf(patch));
      }
    }
    outcome.add(static_cast<int>(side), own);
  }
}
}  // namespace

WheelOutcome combined(int index, const std::vector<PatchOutcome>& patches)
{
  const auto measures_of = [](const PatchOutcome& patch) {
    return ContactMeasures{patch.max_pressure, patch.area, patch.force};
  };
  ContactMeasures all;
  for (const PatchOutcome& patch : patches)
  {
    all.add(measures_of(patch));
  }
  WheelOutcome wheel{index, all.max_pressure, all.area, 0, 0};
  WheelError error(all);
  for (const PatchOutcome& patch : patches)
  {
    wheel.approach += patch.approach * patch.force / all.force;
    error.add(measures_of(patch), patch.error);
  }
  wheel.estimate = error.largest();
  return wheel;
}

void Outcome::add(int index, const std::vector<PatchOutcome>& patches)
{
  if (!patches.empty())
  {
    wheels.push_back(combined(index, patches));
    estimate = std::max(estimate, wheels.back().estimate);
  }
}

double Errors::largest() const
{
  return std::max({max_pressure, area, approach});
}

bool compare(const Outcome& found, const Outcome& truth, Errors& errors)
{
  errors = Errors();
  const auto same = [](const WheelOutcome& a, const WheelOutcome& b) { return a.index == b.index; };
  if (!std::equal(found.wheels.begin(), found.wheels.end(), truth.wheels.begin(), truth.wheels.end(), same))
  {
    return false;
  }
  for (std::size_t k = 0; k < truth.wheels.size(); ++k)
  {
    const WheelOutcome &is = found.wheels[k], &should = truth.wheels[k];
    errors = larger(errors, {std::abs(is.max_pressure / should.max_pressure - 1), std::abs(is.area / should.area - 1),
                             std::abs(is.approach / should.approach - 1)});
  }
  return true;
}

Errors larger(const Errors& a, const Errors& b)
{
  return {std::max(a.max_pressure, b.max_pressure), std::max(a.area, b.area), std::max(a.approach, b.approach)};
}

Outcome outcomeOf(const WheelsetResult& result)
{
  Outcome outcome;
  outcome.usable = isUsable(result.status);
  outcome.reason = outcome.usable ? "" : result.reason;
  addWheels(result.patches, outcome);
  return outcome;
}

Outcome outcomeOf(const WheelsetBalance& balance, ContactStatus status)
{
  Outcome outcome;
  outcome.usable = isUsable(status);
  outcome.reason = balance.reason();
  std::vector<PatchResult> patches;
  for (const Side side : {Side::left, Side::right})
  {
    const bool loaded = outcome.usable && balance.wheel(side).loaded();
    for (std::size_t k = 0; loaded && k < balance.islands(side).islands().size(); ++k)
    {
      fillPatch(side, balance, k, patches.emplace_back());
    }
  }
  addWheels(patches, outcome);
  return outcome;
}
}  // namespace wheel_rail_contact::core::chart
