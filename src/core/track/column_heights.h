// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
/// Distance along the plane at which a point counts as found [m]; the rest is made up for by the slope there, which
/// leaves an error of curvature * tolerance² / 2 < 1e-10 m on the sharpest arcs.
constexpr double tangential_tolerance = 1e-6;

/// A point seen from the plane.
struct LocalPoint
{
  double n = 0;      ///< height over the plane [m]
  double slope = 0;  ///< dn/dt [-]
};

/// Finds the point of a plane curve over place `t` of the plane. `at(u, point)` gives the curve's point in the plane's
/// axes, false where it has none; `u` is a guess and takes the result.
template <typename Curve>
bool pointOver(double t, Curve at, double& u, LocalPoint& out)
{
  constexpr int most_iterations = 12;
  for (int i = 0; i < most_iterations; ++i)
  {
    PlanePoint point;
    if (!at(u, point) || !(point.dy > 0))
    {
      return false;
    }
    const double per_length = 1 / point.dy;
    const double miss = t - point.y;
    u += miss * per_length;
    if (std::abs(miss) < tangential_tolerance)
    {
      out.slope = point.dz * per_length;
      out.n = point.z + out.slope * miss;
      return true;
    }
  }
  return false;
}

/// Columns of a gap that are worked on at once, each with the wheel's profile under its crest (the middle of the
/// column).
struct ColumnGroup
{
  static constexpr int together = 8;
  using Numbers = Eigen::Array<double, together, 1>;

  /// Profile points and derivatives, as in CurveExpansion.
  struct Points
  {
    Numbers y = Numbers::Zero(), z = Numbers::Zero(), dy = Numbers::Zero(), dz = Numbers::Zero();
    Numbers ddy = Numbers::Zero(), ddz = Numbers::Zero(), dddy = Numbers::Zero(), dddz = Numbers::Zero();
  };

  Points profile;
  Numbers u = Numbers::Zero();      ///< parameter of the wheel's profile [m]
  Numbers t = Numbers::Zero();      ///< place in the plane [m]
  Numbers n = Numbers::Zero();      ///< height of the wheel over the plane at the crest [m]
  Numbers reach = Numbers::Zero();  ///< how far along the profile the expansion holds [m]

  void set(int column, double place, double parameter, const CurveExpansion& point, double height,
           double discontinuity_distance);
};

/// Height of the wheel over a group's columns as polynomials of x, from the plane's origin [m]: coefficients by column
/// and power; NaN where the wheel has no point over the column.
using HeightPolynomials = Eigen::Array<double, ColumnGroup::together, 5>;

/// Heights of the wheel over columns, away from their crests.
class ColumnHeights
{
 public:
  /// `seen` are the wheel's sections in the plane's axes (t and n), `plane_x` the plane's origin; keeps a reference
  /// to `profile` alone. The polynomials are those of columns that reach `reach` [m] fore and aft.
  ColumnHeights(const Profile& profile, const WheelSections& seen, double plane_x, double reach, bool symmetric);

  /// The polynomials of columns `0` to `count`, not included.
  HeightPolynomials polynomials(const ColumnGroup& columns, int count) const;

 private:
  using Numbers = ColumnGroup::Numbers;

  Numbers heights(const ColumnGroup& columns, int count, double x) const;
  HeightPolynomials evenPolynomials(const ColumnGroup& columns, int count) const;
  HeightPolynomials fullPolynomials(const ColumnGroup& columns, int count) const;

  const Profile* profile_;
  WheelSections seen_;
  double plane_x_, reach_;  ///< [m]
  bool symmetric_;
};
}  // namespace wheel_rail_contact::core
