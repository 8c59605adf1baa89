// SPDX-License-Identifier: BSD-3-Clause
#include "chart/solver_cache.h"

namespace wheel_rail_contact::core::chart
{
const GridLevels& SolverCache::find(const Choice& choice)
{
  std::unique_ptr<GridLevels>& levels =
      solvers_[{choice.method, choice.grid.along, choice.grid.across, choice.tolerance}];
  if (!levels)
  {
    ContactModelConfig config;
    config.contact = contactConfig(choice);
    levels = std::make_unique<GridLevels>(config);
  }
  return *levels;
}
}  // namespace wheel_rail_contact::core::chart
