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

void Outline::add(const OutlinePoints& points)
{
  const std::size_t count = points.y.size();
  place_.resize(count);
  rise_.resize(count);
  shift_.resize(count);
  const double *y = points.y.data(), *z = points.z.data(), *u = points.u.data();
  double *place = place_.data(), *rise = rise_.data(), *shift = shift_.data();
  const double first = stations_.first, spacing = stations_.spacing, sign = sign_;
  // Divisions are slow: loops without a branch do several at once.
  for (std::size_t i = 0; i < count; ++i)
  {
    place[i] = (y[i] - first) / spacing;
  }
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    rise[i] = sign * (z[i + 1] - z[i]) / (y[i + 1] - y[i]);
    shift[i] = (u[i + 1] - u[i]) / (y[i + 1] - y[i]);
  }
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    addSegment(points, i);
  }
}

/// The segment from a point to the next; none of them if y is not a number.
void Outline::addSegment(const OutlinePoints& points, std::size_t i)
{
  const bool forward = points.y[i] < points.y[i + 1];
  const std::size_t left = forward ? i : i + 1;
  const std::size_t right = forward ? i + 1 : i;
  const double begin = place_[left];
  const double end = std::min(place_[right], static_cast<double>(stations_.count) - 1);
  if (!(end >= 0) || !(end > begin))
  {
    return;
  }
  const auto below = begin > 0 ? static_cast<std::size_t>(begin) : 0;
  const std::size_t first = static_cast<double>(below) < begin ? below + 1 : below;
  for (std::size_t k = first; static_cast<double>(k) <= end; ++k)
  {
    const double run = stations_.y(k) - points.y[left];
    const double height = sign_ * points.z[left] + rise_[i] * run;
    if (height < height_[k])
    {
      height_[k] = height;
      u_[k] = points.u[left] + shift_[i] * run;
    }
  }
}
}  // namespace wheel_rail_contact
