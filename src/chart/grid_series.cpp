// SPDX-License-Identifier: BSD-3-Clause
#include "chart/grid_series.h"

namespace wheel_rail_contact::core::chart
{
const MethodLadder& Ladders::find(const Choice& choice)
{
  std::unique_ptr<MethodLadder>& ladder =
      ladders_[{choice.method, choice.grid.along, choice.grid.across, choice.tolerance}];
  if (!ladder)
  {
    ContactModelConfig config;
    config.contact = contactConfig(choice);
    ladder = std::make_unique<MethodLadder>(config);
  }
  return *ladder;
}
}  // namespace wheel_rail_contact::core::chart
