// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace wheel_rail_contact::core
{
/// Root of a function that changes its sign between `low` and `high`, by bisection.
inline double root(const std::function<double(double)>& value, double low, double high)
{
  const bool rises = value(low) < 0;
  for (int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    ((value(middle) < 0) == rises ? low : high) = middle;
  }
  return 0.5 * (low + high);
}
}  // namespace wheel_rail_contact::core
