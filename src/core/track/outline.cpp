// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/outline.h"

#include <algorithm>
#include <limits>

#include "core/constants.h"
#include "core/simd/wide.h"

namespace wheel_rail_contact::core
{
void Outline::start(const Stations& stations)
{
  stations_ = stations;
  height_.assign(stations.count, infinity);
  u_.assign(stations.count, std::numeric_limits<double>::quiet_NaN());
}

void Outline::reserve(std::size_t points)
{
  for (std::vector<double>* of_points : {&place_, &dz_dy_, &du_dy_})
  {
    of_points->reserve(points);
  }
}

/// Computes the positions of the points and the derivatives on the segments. Divisions are slow; loops without branches
/// compute several at once.
WHEEL_RAIL_CONTACT_WIDE void Outline::measureSegments(const OutlinePoints& points, std::size_t first_point,
                                                      std::size_t end_point)
{
  const std::size_t count = points.y.size();
  place_.resize(count);
  dz_dy_.resize(count);
  du_dy_.resize(count);
  const double *y = points.y.data(), *z = points.z.data(), *u = points.u.data();
  double *place = place_.data(), *dz_dy = dz_dy_.data(), *du_dy = du_dy_.data();
  const double first = stations_.first, per_spacing = 1 / stations_.spacing, sign = sign_;
  for (std::size_t i = first_point; i < end_point; ++i)
  {
    place[i] = (y[i] - first) * per_spacing;
  }
  for (std::size_t i = first_point; i + 1 < end_point; ++i)
  {
    const double per_run = 1 / (y[i + 1] - y[i]);
    dz_dy[i] = sign * (z[i + 1] - z[i]) * per_run;
    du_dy[i] = (u[i + 1] - u[i]) * per_run;
  }
}

WHEEL_RAIL_CONTACT_WIDE void Outline::above(const Outline& other, std::vector<double>& distance) const
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

void Outline::add(const OutlinePoints& points, std::size_t first_point, std::size_t end_point)
{
  measureSegments(points, first_point, end_point);
  // Copies: the compiler would otherwise assume that writing to `height` changes them, and load them again.
  double *height = height_.data(), *parameter = u_.data();
  const double *place = place_.data(), *dz_dy = dz_dy_.data(), *du_dy = du_dy_.data();
  const double *y = points.y.data(), *z = points.z.data(), *u = points.u.data();
  const double first = stations_.first, spacing = stations_.spacing, sign = sign_;
  const double last = static_cast<double>(stations_.count) - 1;
  double done = -1;    // end of the preceding segment, in units of stations
  double station = 0;  // first station beyond it
  long k = 0;          // the same as an integer; signed integers convert faster
  for (std::size_t i = first_point; i + 1 < end_point; ++i)
  {
    const double begin = std::min(place[i], place[i + 1]);
    const double end = std::min(std::max(place[i], place[i + 1]), last);
    if (!(end >= 0) || !(end > begin))
    {
      continue;  // the segment is beside all stations, or y is NaN
    }
    if (begin != done)
    {
      k = static_cast<long>(std::max(begin, 0.0));
      k += static_cast<double>(k) < begin ? 1 : 0;
      station = static_cast<double>(k);
    }
    for (; station <= end; station += 1, ++k)
    {
      const double run = first - y[i] + station * spacing;
      const double here = sign * z[i] + dz_dy[i] * run;
      if (here < height[k])
      {
        height[k] = here;
        parameter[k] = u[i] + du_dy[i] * run;
      }
    }
    done = end;
  }
}
}  // namespace wheel_rail_contact::core
