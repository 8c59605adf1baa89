// SPDX-License-Identifier: BSD-3-Clause
#include "chart/method_run.h"

namespace wheel_rail_contact::core::chart
{
std::vector<Choice> allChoices()
{
  const ContactModelConfig automatic;
  const GridLevels levels(automatic);
  std::vector<Choice> choices;
  for (const NormalMethod method : {NormalMethod::hertz, NormalMethod::kik_piotrowski, NormalMethod::seidel_printed,
                                    NormalMethod::seidel, NormalMethod::conjugate_gradient})
  {
    for (std::size_t level = 0; level < levels.count(); ++level)
    {
      choices.push_back({method, levels.at(level).size, 0});
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
