// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/noise/curve_windows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
constexpr std::size_t neighbours = 4;
}  // namespace

CurveWindows::CurveWindows(const std::vector<SampledPoint>& points) : points_(points), length_{0}
{
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length_.push_back(length_.back() + std::hypot(points[i].y - points[i - 1].y, points[i].z - points[i - 1].z));
  }
}

/// Nearest point at least the spacing before a point, outside of the range; nowhere if the curve begins later.
std::size_t CurveWindows::before(std::size_t point, std::size_t first, std::size_t last) const
{
  for (std::size_t i = point; i-- > 0;)
  {
    if (length_[point] - length_[i] >= least_spacing && !(i >= first && i <= last))
    {
      return i;
    }
  }
  return nowhere;
}

/// Nearest point at least the spacing after a point, outside of the range; nowhere if the curve ends earlier.
std::size_t CurveWindows::after(std::size_t point, std::size_t first, std::size_t last) const
{
  for (std::size_t i = point + 1; i < length_.size(); ++i)
  {
    if (length_[i] - length_[point] >= least_spacing && !(i >= first && i <= last))
    {
      return i;
    }
  }
  return nowhere;
}

std::optional<CurveWindows::Residual> CurveWindows::residual(std::size_t first, std::size_t last,
                                                             std::size_t skip_first, std::size_t skip_last) const
{
  const std::size_t left = before(first, skip_first, skip_last), right = after(last, skip_first, skip_last);
  if (left == nowhere || right == nowhere)
  {
    return std::nullopt;
  }
  const std::size_t far_left = before(left, skip_first, skip_last), far_right = after(right, skip_first, skip_last);
  if (far_left == nowhere || far_right == nowhere || length_[far_right] - length_[far_left] > longest)
  {
    return std::nullopt;
  }
  const std::array<std::size_t, neighbours> around{far_left, left, right, far_right};
  const SampledPoint &begin = points_[left], &end = points_[right];
  const double dy = end.y - begin.y, dz = end.z - begin.z, chord = std::hypot(dy, dz);
  const SampledPoint &first_of_all = points_[far_left], &last_of_all = points_[far_right];
  const double y1 = begin.y - first_of_all.y, z1 = begin.z - first_of_all.z;
  const double y2 = last_of_all.y - end.y, z2 = last_of_all.z - end.z;
  Residual result{
      0, 0, 1, std::abs(dy) >= std::abs(dz), chord, std::abs(std::atan2(y1 * z2 - z1 * y2, y1 * y2 + z1 * z2))};
  for (std::size_t i = first; i <= last; ++i)
  {
    double y = points_[i].y, z = points_[i].z, squares = 1;
    for (const std::size_t a : around)
    {
      double weight = 1;
      for (const std::size_t b : around)
      {
        weight *= a == b ? 1 : (length_[i] - length_[b]) / (length_[a] - length_[b]);
      }
      y -= weight * points_[a].y;
      z -= weight * points_[a].z;
      squares += weight * weight;
    }
    const double across = (dy * z - dz * y) / chord;
    result.at_first = i == first ? across : result.at_first;
    if (std::abs(across) > std::abs(result.across) || i == first)
    {
      result.across = across;
      result.deviation = std::sqrt(squares);
    }
  }
  return result;
}

std::optional<CurveWindows::Residual> CurveWindows::residual(std::size_t first, std::size_t last) const
{
  return residual(first, last, nowhere, nowhere);
}

std::optional<CurveWindows::Residual> CurveWindows::residualWithout(std::size_t point, std::size_t first,
                                                                    std::size_t last) const
{
  return residual(point, point, first, last);
}
}  // namespace wheel_rail_contact::core
