// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Place up to which a condition holds, by halving. It holds at `inside`, which may be the larger one, not at
/// `outside`.
template <typename Condition>
double lastWhere(const Condition& holds, double inside, double outside)
{
  for (int halving = 0; halving < 100; ++halving)
  {
    const double middle = 0.5 * (inside + outside);
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}
}  // namespace wheel_rail_contact::core
