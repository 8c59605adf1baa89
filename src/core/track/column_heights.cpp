// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/column_heights.h"

#include <algorithm>
#include <limits>

#include "core/simd/wide.h"

namespace wheel_rail_contact::core
{
/// Largest distance from the middle of a column over which the third-order expansion of the wheel profile is used [m].
/// The fourth derivative causes an error of 1e-11 m on arcs of 13 mm.
constexpr double expansion_reach = 1.5e-4;

void ColumnGroup::set(int column, const WheelSections& seen, double parameter, const CurveExpansion& point,
                      double discontinuity_distance)
{
  const CurvePoint& p = point.point;
  values.row(column) << seen.y.origin, seen.y.along, seen.y.down, seen.y.forward,  //
      seen.z.origin, seen.z.along, seen.z.down, seen.z.forward,                    //
      p.y, p.z, p.dy, p.dz, p.ddy, p.ddz, point.dddy, point.dddz, std::min(discontinuity_distance, expansion_reach);
  u[column] = parameter;
}

inline WheelSections ColumnGroup::seen(int column, const WheelSections& wheel) const
{
  const auto at = [&](int first) -> WheelCoordinate {
    return {values(column, first), values(column, first + 1), values(column, first + 2), values(column, first + 3)};
  };
  return {wheel.radius, wheel.half_base, wheel.axle_x, wheel.per_forward_x, at(tangent), at(normal)};
}

inline CurvePoint ColumnGroup::beside(int column, double shift) const
{
  const double half = 0.5 * shift, third = shift * (1.0 / 3);
  const auto at = [&](int k) { return values(column, k); };
  return {at(y) + shift * (at(dy) + half * (at(ddy) + third * at(dddy))),
          at(z) + shift * (at(dz) + half * (at(ddz) + third * at(dddz))),
          at(dy) + shift * (at(ddy) + half * at(dddy)),
          at(dz) + shift * (at(ddz) + half * at(dddz)),
          0,
          0};
}

/// Two Newton steps on the expansion: sets height and slope in each column, and 1 where they are accurate, otherwise 0.
static WHEEL_RAIL_CONTACT_WIDE void expand(const ColumnGroup& columns, const WheelSections& wheel, double x,
                                           Eigen::Array<double, ColumnGroup::together, 3>& out)
{
  const auto reach = columns.values.col(ColumnGroup::reach);
  Eigen::Array<double, ColumnGroup::together, 3> own;  // the compiler knows that it shares no memory with the columns
  for (int k = 0; k < ColumnGroup::together; ++k)
  {
    const WheelSections seen = columns.seen(k, wheel);
    PlanePoint start{}, point{};
    seen.at(columns.beside(k, 0), x, start);
    const double shift = -start.y / start.dy;
    seen.at(columns.beside(k, shift), x, point);
    own(k, 1) = point.dz / point.dy;
    own(k, 0) = point.z - own(k, 1) * point.y;
    const double is_over = std::abs(point.y) < tangential_tolerance ? 1 : 0;
    const double is_near = std::abs(shift) < reach[k] ? 1 : 0;
    own(k, 2) = point.dy > 0 ? is_over * is_near : 0;
  }
  out = own;
}

ColumnHeights::Numbers ColumnHeights::heights(const ColumnGroup& columns, int count, double x, Numbers& u,
                                              Numbers& slope)
{
  Eigen::Array<double, ColumnGroup::together, 3> expanded;
  expand(columns, wheel_, x, expanded);
  Numbers n = expanded.col(0);
  slope = expanded.col(1);
  for (int k = 0; k < count; ++k)
  {
    if (!(expanded(k, 2) > 0))
    {
      const WheelSections seen = columns.seen(k, wheel_);
      const auto curve = [&](double at, PlanePoint& place) { return seen.at(profile_.at(at), x, place); };
      LocalPoint local;
      double guess = u[k];
      const bool there = pointOver(0, curve, guess, local);
      n[k] = there ? local.n : std::numeric_limits<double>::quiet_NaN();
      slope[k] = local.slope;
      u[k] = there ? guess : u[k];
    }
  }
  return n;
}
}  // namespace wheel_rail_contact::core
