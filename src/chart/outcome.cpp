// SPDX-License-Identifier: BSD-3-Clause
#include "chart/outcome.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core::chart
{
namespace
{
void takeFiner(GridSize grid, std::string_view solver, Outcome& outcome)
{
  if (grid.along * grid.across > outcome.grid.along * outcome.grid.across)
  {
    outcome.grid = grid;
    outcome.solver = solver;
  }
}
}  // namespace

double Errors::largest() const
{
  return std::max({max_pressure, area, approach});
}

bool compare(const Outcome& found, const Outcome& truth, Errors& errors)
{
  errors = Errors();
  const auto same_body = [](const PatchOutcome& a, const PatchOutcome& b) { return a.body == b.body; };
  if (!std::equal(found.patches.begin(), found.patches.end(), truth.patches.begin(), truth.patches.end(), same_body))
  {
    return false;
  }
  for (std::size_t k = 0; k < truth.patches.size(); ++k)
  {
    const PatchOutcome &is = found.patches[k], &should = truth.patches[k];
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
  for (const PatchResult& patch : result.patches)
  {
    takeFiner({patch.grid.nx, patch.grid.ny}, patch.method, outcome);
    outcome.estimate = std::max(outcome.estimate, patch.error_estimate);
    outcome.patches.push_back({static_cast<int>(patch.side), patch.max_pressure, patch.area, patch.approach});
  }
  return outcome;
}

Outcome outcomeOf(const WheelsetBalance& balance, ContactStatus status)
{
  Outcome outcome;
  outcome.usable = isUsable(status);
  outcome.reason = balance.reason();
  for (const Side side : {Side::left, Side::right})
  {
    const WheelContact& wheel = balance.wheel(side);
    for (std::size_t k = 0; outcome.usable && k < wheel.patches().size(); ++k)
    {
      const PatchPressure& pressure = wheel.solution().patches[k];
      const Grid& grid = wheel.problem().patches[k].grid;
      if (pressure.force > 0)
      {
        takeFiner({grid.nx, grid.ny}, wheel.solver().name(), outcome);
        outcome.patches.push_back(
            {static_cast<int>(side), pressure.max_pressure, pressure.area, wheel.patchApproach(k)});
      }
    }
  }
  return outcome;
}
}  // namespace wheel_rail_contact::core::chart
