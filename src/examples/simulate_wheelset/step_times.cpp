// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/step_times.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace simulate_wheelset
{
std::string StepTimes::text() const
{
  if (seconds_.empty())
  {
    return "";
  }
  std::vector<double> sorted = seconds_;
  std::sort(sorted.begin(), sorted.end());
  const auto quantile = [&](double share)
  { return 1e3 * sorted[static_cast<std::size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)))]; };
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << static_cast<double>(sorted.size()) / sum << " steps/s; step: median "
       << std::setprecision(3) << quantile(0.5) << " ms, 95 % " << quantile(0.95) << " ms, longest " << quantile(1)
       << " ms";
  return text.str();
}
}  // namespace simulate_wheelset
