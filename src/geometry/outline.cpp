// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/geometry/outline.h"

#include <algorithm>

namespace wheel_rail_contact
{
void Outline::start(const Stations& stations)
{
  stations_ = stations;
  height_.assign(stations.count, std::numeric_limits<double>::infinity());
  u_.assign(stations.count, 0);
}

/// Places of points and steepness of the segments behind them. Divisions are slow: loops without a branch do several at
/// once.
void Outline::measureSegments(const OutlinePoints& points, std::size_t first_point, std::size_t behind)
{
  const std::size_t count = points.y.size();
  place_.resize(count);
  rise_.resize(count);
  shift_.resize(count);
  const double *y = points.y.data(), *z = points.z.data(), *u = points.u.data();
  double *place = place_.data(), *rise = rise_.data(), *shift = shift_.data();
  const double first = stations_.first, per_spacing = 1 / stations_.spacing, sign = sign_;
  for (std::size_t i = first_point; i < behind; ++i)
  {
    place[i] = (y[i] - first) * per_spacing;
  }
  for (std::size_t i = first_point; i + 1 < behind; ++i)
  {
    const double per_run = 1 / (y[i + 1] - y[i]);
    rise[i] = sign * (z[i + 1] - z[i]) * per_run;
    shift[i] = (u[i + 1] - u[i]) * per_run;
  }
}

void Outline::add(const OutlinePoints& points, std::size_t first_point, std::size_t behind)
{
  measureSegments(points, first_point, behind);
  // To the compiler, what is written may change any number it does not hold itself.
  double *height = height_.data(), *parameter = u_.data();
  const double first = stations_.first, spacing = stations_.spacing, sign = sign_;
  const double last = static_cast<double>(stations_.count) - 1;
  for (std::size_t i = first_point; i + 1 < behind; ++i)
  {
    const double begin = std::min(place_[i], place_[i + 1]);
    const double end = std::min(std::max(place_[i], place_[i + 1]), last);
    if (!(end >= 0) || !(end > begin))
    {
      continue;  // beside the stations, or y is not a number
    }
    const double from_point = first - points.y[i];
    const double z = sign * points.z[i], rise = rise_[i], u = points.u[i], shift = shift_[i];
    const long behind_last = static_cast<long>(end) + 1;  // signed numbers convert faster
    const long below = begin > 0 ? static_cast<long>(begin) : 0;
    for (long k = static_cast<double>(below) < begin ? below + 1 : below; k < behind_last; ++k)
    {
      const double run = from_point + static_cast<double>(k) * spacing;
      if (z + rise * run < height[k])
      {
        height[k] = z + rise * run;
        parameter[k] = u + shift * run;
      }
    }
  }
}
}  // namespace wheel_rail_contact
