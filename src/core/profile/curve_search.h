// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core
{
/// Value of a point of a curve [m].
using PointValue = std::function<double(const CurvePoint&)>;

/// First parameter u at which a value changes its sign, from the parameter `from` towards `to` [m]; nothing if it does
/// not. Two changes within 0.1 mm may be missed.
std::optional<double> firstZero(const Profile& profile, const PointValue& value, double from, double to);

/// Parameter u of the largest value in a range [m].
double whereLargest(const Profile& profile, const PointValue& value, const ParameterRange& range);

/// Finds the points of a curve that are nearest to given points.
class CurveFeet
{
 public:
  /// Keeps a reference to `profile`, which must outlive the object.
  explicit CurveFeet(const Profile& profile);

  /// Parameter u of the point of the curve that is nearest to the point (y, z) [m].
  double nearest(double y, double z) const;
  /// True if the curve ends at the parameter u: a point nearest to it lies beyond the end.
  bool isEnd(double u) const;

 private:
  const Profile* profile_;
  double spacing_;  ///< of the points, in u [m]
  std::vector<CurvePoint> points_;
};

/// Distance of the point (y, z) from the curve point p, across the curve [m]; positive to the left of the direction of
/// growing u: above a rail head or a tread.
double distanceAcross(const CurvePoint& p, double y, double z);
}  // namespace wheel_rail_contact::core
