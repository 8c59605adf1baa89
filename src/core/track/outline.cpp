// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/outline.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
void Outline::start(const Stations& stations)
{
  stations_ = stations;
  height_.assign(stations.count, std::numeric_limits<double>::infinity());
  u_.resize(stations.count);
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

void Outline::above(const Outline& other, std::vector<double>& distance) const
{
  const double *here = height_.data(), *there = other.height_.data();
  const double sign = sign_, other_sign = other.sign_;
  double* out = distance.data();
  const std::size_t count = height_.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    out[k] = sign * here[k] - other_sign * there[k];
  }
}

void Outline::add(const OutlinePoints& points, std::size_t first_point, std::size_t behind)
{
  measureSegments(points, first_point, behind);
  // To the compiler, what is written may change any number it does not hold itself.
  double *height = height_.data(), *parameter = u_.data();
  const double *place = place_.data(), *rise = rise_.data(), *shift = shift_.data();
  const double *y = points.y.data(), *z = points.z.data(), *u = points.u.data();
  const double first = stations_.first, spacing = stations_.spacing, sign = sign_;
  const double last = static_cast<double>(stations_.count) - 1;
  double walked = -1;  // place up to which stations lie behind
  double station = 0;  // the first one beyond it
  long k = 0;          // the same; signed numbers convert faster
  for (std::size_t i = first_point; i + 1 < behind; ++i)
  {
    const double begin = std::min(place[i], place[i + 1]);
    const double end = std::min(std::max(place[i], place[i + 1]), last);
    if (!(end >= 0) || !(end > begin))
    {
      continue;  // beside the stations, or y is not a number
    }
    if (begin != walked)
    {
      k = static_cast<long>(std::max(begin, 0.0));
      k += static_cast<double>(k) < begin ? 1 : 0;
      station = static_cast<double>(k);
    }
    for (; station <= end; station += 1, ++k)
    {
      const double run = first - y[i] + station * spacing;
      const double here = sign * z[i] + rise[i] * run;
      if (here < height[k])
      {
        height[k] = here;
        parameter[k] = u[i] + shift[i] * run;
      }
    }
    walked = end;
  }
}
}  // namespace wheel_rail_contact::core
