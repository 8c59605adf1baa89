// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/column_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core
{
namespace
{
/// Largest distance from the middle of a column over which the third-order expansion of the wheel profile is used [m].
/// The fourth derivative causes an error of 1e-11 m on arcs of 13 mm.
constexpr double expansion_reach = 1.5e-4;

using Numbers = ColumnGroup::Numbers;

/// Profile points with tangents.
struct Tangents
{
  Numbers y, z, dy, dz;
};

/// Points and tangents of the profile at a distance `shift` along it, from the expansion.
Tangents beside(const ColumnGroup::Points& p, const Numbers& shift)
{
  const Numbers half = 0.5 * shift;
  const Numbers third = shift * (1.0 / 3);
  return {p.y + shift * (p.dy + half * (p.ddy + third * p.dddy)),
          p.z + shift * (p.dz + half * (p.ddz + third * p.dddz)), p.dy + shift * (p.ddy + half * p.dddy),
          p.dz + shift * (p.ddz + half * p.dddz)};
}
}  // namespace

void fillColumn(const Grid& grid, const HeightPolynomial& polynomial, double* height)
{
  // Copies: the compiler would otherwise assume that writing to `height` changes them, and load them again.
  const double c0 = polynomial[0], c1 = polynomial[1], c2 = polynomial[2], c3 = polynomial[3], c4 = polynomial[4];
  const Grid g = grid;
  for (int row = 0; row < g.rows(); ++row)
  {
    const double x = g.x(row);
    height[row] = c0 + x * (c1 + x * (c2 + x * (c3 + x * c4)));
  }
}

void ColumnGroup::Coordinate::set(int column, const WheelCoordinate& value)
{
  origin[column] = value.origin;
  along[column] = value.along;
  down[column] = value.down;
  forward[column] = value.forward;
}

void ColumnGroup::set(int column, const WheelSections& seen, double place, double parameter,
                      const CurveExpansion& point, double height, double discontinuity_distance)
{
  tangent.set(column, seen.y);
  normal.set(column, seen.z);
  const CurvePoint& p = point.point;
  profile.y[column] = p.y;
  profile.z[column] = p.z;
  profile.dy[column] = p.dy;
  profile.dz[column] = p.dz;
  profile.ddy[column] = p.ddy;
  profile.ddz[column] = p.ddz;
  profile.dddy[column] = point.dddy;
  profile.dddz[column] = point.dddz;
  u[column] = parameter;
  t[column] = place;
  n[column] = height;
  reach[column] = std::min(discontinuity_distance, expansion_reach);
}

WheelSections ColumnGroup::seen(int column, const WheelSections& wheel) const
{
  const auto value = [column](const Coordinate& c) -> WheelCoordinate {
    return {c.origin[column], c.along[column], c.down[column], c.forward[column]};
  };
  WheelSections sections = wheel;
  sections.y = value(tangent);
  sections.z = value(normal);
  return sections;
}

ColumnHeights::ColumnHeights(const Profile& profile, const WheelSections& wheel, double plane_x, double reach,
                             bool symmetric)
    : profile_(&profile), wheel_(wheel), plane_x_(plane_x), reach_(reach), symmetric_(symmetric)
{
}

/// Heights at x [m] from the origin of the plane: two Newton steps on the expansion. Where the expansion is not
/// accurate, Newton's method on the profile itself.
Numbers ColumnHeights::heights(const ColumnGroup& columns, int count, double x) const
{
  const double at_x = plane_x_ + x;
  const SectionPoint<Numbers> start = wheel_.at<Numbers>(columns.profile, at_x, columns.tangent, columns.normal);
  const Numbers shift = (columns.t - start.y) / start.dy;
  const SectionPoint<Numbers> point =
      wheel_.at<Numbers>(beside(columns.profile, shift), at_x, columns.tangent, columns.normal);
  const Numbers miss = columns.t - point.y;
  Numbers n = point.z + point.dz / point.dy * miss;
  for (int k = 0; k < count; ++k)
  {
    const bool found =
        point.dy[k] > 0 && std::abs(miss[k]) < tangential_tolerance && std::abs(shift[k]) < columns.reach[k];
    if (!found)
    {
      const WheelSections seen = columns.seen(k, wheel_);
      const auto curve = [&](double u, PlanePoint& at) { return seen.at(profile_->at(u), at_x, at); };
      double u = columns.u[k];
      LocalPoint local;
      n[k] = pointOver(columns.t[k], curve, u, local) ? local.n : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return n;
}

/// Even polynomials through the middle and two points in front of it.
HeightPolynomials ColumnHeights::evenPolynomials(const ColumnGroup& columns, int count) const
{
  const double inner = 0.6 * reach_;
  const double inner_square = inner * inner;
  const double outer_square = reach_ * reach_;
  const Numbers second_inner = (heights(columns, count, inner) - columns.n) * (1 / inner_square);
  const Numbers second_outer = (heights(columns, count, reach_) - columns.n) * (1 / outer_square);
  const Numbers fourth = (second_outer - second_inner) * (1 / (outer_square - inner_square));
  HeightPolynomials c = HeightPolynomials::Zero();
  c.col(0) = columns.n;
  c.col(2) = second_inner - fourth * inner_square;
  c.col(4) = fourth;
  return c;
}

/// Polynomials through the middle, two points in front of it and two points behind it.
HeightPolynomials ColumnHeights::fullPolynomials(const ColumnGroup& columns, int count) const
{
  const double h = 0.5 * reach_;
  const double per_h = 1 / h;
  const double per_square = per_h * per_h;
  const Numbers fore = heights(columns, count, h);
  const Numbers aft = heights(columns, count, -h);
  const Numbers far_fore = heights(columns, count, 2 * h);
  const Numbers far_aft = heights(columns, count, -2 * h);
  const Numbers odd = 0.5 * (fore - aft);
  const Numbers even = 0.5 * (fore + aft) - columns.n;
  const Numbers third = (0.5 * (far_fore - far_aft) - 2 * odd) * (1.0 / 6);
  const Numbers fourth = (0.5 * (far_fore + far_aft) - columns.n - 4 * even) * (1.0 / 12);
  HeightPolynomials c;
  c.col(0) = columns.n;
  c.col(1) = (odd - third) * per_h;
  c.col(2) = (even - fourth) * per_square;
  c.col(3) = third * per_square * per_h;
  c.col(4) = fourth * per_square * per_square;
  return c;
}

HeightPolynomials ColumnHeights::polynomials(const ColumnGroup& columns, int count) const
{
  return symmetric_ ? evenPolynomials(columns, count) : fullPolynomials(columns, count);
}
}  // namespace wheel_rail_contact::core
