// SPDX-License-Identifier: BSD-3-Clause
#include "chart/method_run.h"

#include <algorithm>

namespace wheel_rail_contact::core::chart
{
namespace
{
/// Grids of `auto` at all tolerances, from coarse to fine.
std::vector<GridSize> allGrids()
{
  std::vector<GridSize> grids;
  for (const double tolerance : tolerances)
  {
    ContactModelConfig config;
    config.contact.tolerance = tolerance;
    const GridLevels levels(config);
    for (std::size_t level = 0; level < levels.count(); ++level)
    {
      if (std::find(grids.begin(), grids.end(), levels.at(level)) == grids.end())
      {
        grids.push_back(levels.at(level));
      }
    }
  }
  return grids;
}
}  // namespace

std::vector<Choice> allChoices()
{
  const std::vector<GridSize> grids = allGrids();
  std::vector<Choice> choices;
  for (const NormalMethod method : {NormalMethod::hertz, NormalMethod::kik_piotrowski, NormalMethod::seidel_printed,
                                    NormalMethod::seidel, NormalMethod::conjugate_gradient})
  {
    for (const GridSize& grid : grids)
    {
      choices.push_back({method, grid, 0});
    }
  }
  for (const double tolerance : tolerances)
  {
    choices.push_back({NormalMethod::automatic, {}, tolerance});
  }
  return choices;
}

ContactConfig contactConfig(const Choice& choice)
{
  ContactConfig contact;
  contact.method = choice.method;
  contact.cells_along = choice.grid.along;
  contact.cells_across = choice.grid.across;
  contact.tolerance = choice.tolerance > 0 ? choice.tolerance : contact.tolerance;
  return contact;
}
}  // namespace wheel_rail_contact::core::chart
