// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/profile/noise/curve_windows.h"
#include "core/profile/noise/noise.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t least_residuals = 11;
constexpr std::size_t block = 60;
/// Median of the absolute value of a normal variable of standard deviation 1.
constexpr double normal_median = 0.6745;

/// Residuals of the points for noise of 1, of the flat part or of the whole curve [m].
std::vector<double> residuals(const std::vector<SampledPoint>& points, bool only_flat)
{
  const CurveWindows windows(points);
  std::vector<double> result;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto residual = windows.residual(i, i);
    if (residual && (residual->flat || !only_flat))
    {
      result.push_back(std::abs(residual->across) / residual->deviation);
    }
  }
  return result;
}

double medianOf(std::vector<double>::iterator begin, std::vector<double>::iterator end)
{
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end);
  return *middle;
}
}  // namespace

std::optional<NoiseEstimate> estimatedNoise(const std::vector<SampledPoint>& points)
{
  std::vector<double> found = residuals(points, true);
  found = found.size() >= least_residuals ? found : residuals(points, false);
  if (found.size() < least_residuals)
  {
    return std::nullopt;
  }
  const std::size_t blocks = std::max<std::size_t>(1, found.size() / block);
  double largest = 0;
  for (std::size_t k = 0; k < blocks; ++k)
  {
    const auto at = [&](std::size_t part)
    { return found.begin() + static_cast<std::ptrdiff_t>(part * found.size() / blocks); };
    largest = std::max(largest, medianOf(at(k), at(k + 1)));
  }
  const double typical = medianOf(found.begin(), found.end());
  return NoiseEstimate{typical / normal_median, std::max(typical, largest) / normal_median};
}
}  // namespace wheel_rail_contact::core
