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

void Outline::add(const OutlinePoint& a, const OutlinePoint& b)
{
  const OutlinePoint& left = a.y < b.y ? a : b;
  const OutlinePoint& right = a.y < b.y ? b : a;
  const double begin = (left.y - stations_.first) / stations_.spacing;
  const double end =
      std::min((right.y - stations_.first) / stations_.spacing, static_cast<double>(stations_.count) - 1);
  if (!(end >= 0) || !(end > begin))
  {
    return;
  }
  const auto below = begin > 0 ? static_cast<std::size_t>(begin) : 0;
  const std::size_t first = static_cast<double>(below) < begin ? below + 1 : below;
  const double rise = sign_ * (right.z - left.z) / (right.y - left.y);
  const double shift = (right.u - left.u) / (right.y - left.y);
  for (std::size_t k = first; static_cast<double>(k) <= end; ++k)
  {
    const double run = stations_.y(k) - left.y;
    const double height = sign_ * left.z + rise * run;
    if (height < height_[k])
    {
      height_[k] = height;
      u_[k] = left.u + shift * run;
    }
  }
}
}  // namespace wheel_rail_contact
