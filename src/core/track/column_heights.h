// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/track/placement.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Distance along the plane below which the search for a point ends [m]. The slope corrects for the remaining distance.
/// The error is then curvature * tolerance² / 2 < 1e-10 m on the sharpest arcs.
constexpr double tangential_tolerance = 1e-6;

/// Height and slope of a curve relative to a contact plane.
struct LocalPoint
{
  double n = 0;      ///< height above the plane [m]
  double slope = 0;  ///< dn/dt [-]
};

/// Finds the point of a curve above the position `t` [m] of a contact plane, by Newton's method.
/// @param at  at(u, point) computes the point at the parameter u, in the axes of the plane; returns false if there is
/// none
/// @param u   initial guess; the result on return
/// @return false if no point was found.
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

/// Group of gap columns that are computed at the same time (SIMD). For each column, it holds the point of the wheel
/// profile above the middle of the column (x = 0).
struct ColumnGroup
{
  static constexpr int together = 8;  ///< number of columns in a group
  using Numbers = Eigen::Array<double, together, 1>;

  /// Values of one column of the gap.
  enum Value
  {
    tangent = 0,  ///< coordinate of the wheel along the plane of the column: four values, as in WheelCoordinate
    normal = 4,   ///< the same normal to the plane
    y = 8,        ///< of the profile point [m]; its derivatives follow, as in CurveExpansion
    z,
    dy,
    dz,
    ddy,
    ddz,
    dddy,
    dddz,
    reach,  ///< distance along the profile within which the expansion is accurate [m]
    value_count
  };

  /// A row for each column of the gap, a column for each Value.
  Eigen::Array<double, together, value_count> values = Eigen::Array<double, together, value_count>::Zero();
  Numbers u = Numbers::Zero();  ///< parameters of the wheel profile [m]

  /// Sets the values of one column.
  /// @param seen  sections of the wheel in the axes of the plane of the column, from its middle
  /// @param discontinuity_distance  distance along the profile to the nearest discontinuity [m]
  void set(int column, const WheelSections& seen, double parameter, const CurveExpansion& point,
           double discontinuity_distance);

  /// Sections of the wheel in the axes of one column. The coordinates of `wheel` are not used.
  WheelSections seen(int column, const WheelSections& wheel) const;
  /// Point and tangent of the profile at a distance `shift` along it, from the expansion.
  CurvePoint beside(int column, double shift) const;
};

/// Computes the heights of the wheel along columns of a gap.
class ColumnHeights
{
 public:
  using Numbers = ColumnGroup::Numbers;

  /// Keeps a reference to `profile`.
  /// @param profile  of the wheel
  /// @param wheel    sections of the wheel; its coordinates are not used
  ColumnHeights(const Profile& profile, const WheelSections& wheel) : profile_(profile), wheel_(wheel) {}

  /// Heights of the wheel above the first `count` columns of the group at x [m], and their slopes across the track;
  /// NaN if there is none.
  /// @param u  parameters of the wheel profile [m]: start of the search where the expansion is not accurate; set to the
  ///           result there
  Numbers heights(const ColumnGroup& columns, int count, double x, Numbers& u, Numbers& slope);

 private:
  ProfileCursor profile_;
  WheelSections wheel_;
};
}  // namespace wheel_rail_contact::core
