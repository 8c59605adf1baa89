// SPDX-License-Identifier: BSD-3-Clause
#include "chart/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core::chart
{
double quantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto place = std::lround(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}
}  // namespace wheel_rail_contact::core::chart
