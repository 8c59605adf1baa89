// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/profile/file_profile.h"

namespace wheel_rail_contact::core
{
/// Single points, and groups of two or three, that lie off the curve of their neighbours.
struct Outliers
{
  std::size_t count = 0;
  double largest = 0;    ///< distance from the curve [m]
  std::size_t line = 0;  ///< of the farthest one in the file
};

/// Omits outliers: points more than 10 times the noise, and more than 5 um, off the cubic through two neighbours on
/// either side, if the curve is smooth without them. Corners and kinks are no outliers: there the neighbours are off,
/// too.
/// @param noise   standard deviation of the points [m]
/// @param most    number of points from which the search ends
/// @param points  in order along the curve
Outliers omitOutliers(double noise, std::size_t most, std::vector<FilePoint>& points);
}  // namespace wheel_rail_contact::core
