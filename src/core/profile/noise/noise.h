// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/profile/curve/spline.h"

namespace wheel_rail_contact::core
{
/// Standard deviation of points across their curve.
struct NoiseEstimate
{
  double typical;  ///< of all points [m]
  double largest;  ///< of the noisiest stretch [m]
};

/// Estimates the standard deviation of points across their curve; nothing if there are too few of them.
///
/// Each point is compared with the cubic curve through its four neighbours (CurveWindows). These residuals, divided by
/// their own standard deviation for noise of 1, are independent of the curve (Gasser, Sroka and Jennen-Steinmetz,
/// Residual variance and residual pattern in nonlinear regression, Biometrika 73, 1986). Their median is insensitive to
/// corners. Only the part that is flatter than 45 degrees counts, where contacts are: noise of heights alone does not
/// show on the sides. Noise need not be the same everywhere: the largest estimate is that of blocks of 60 residuals. It
/// is thereby about a quarter too large for equal noise. Too much smoothing does less harm than too little.
/// @param points  in order along the curve
std::optional<NoiseEstimate> estimatedNoise(const std::vector<SampledPoint>& points);

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
Outliers omitOutliers(double noise, std::size_t most, std::vector<SampledPoint>& points);

/// Sets the error of an interpolating spline by noise of its points [m]: on equal sections of length h, the second
/// derivative at a point has the standard deviation 6 noise/h² (from the spectrum of the spline's equations).
void addInterpolationError(double noise, std::vector<ProfileSection>& sections);

/// Marks the sections where points are missing: neighbours are more than 2 mm and more than 5 times the median distance
/// apart, or more than 4 mm. A straight line that is given by its ends is known, if it continues segments before and
/// after it, and if it is steeper than 45 degrees or the points are exact: a tread that a laser did not see may be
/// hollow.
/// @param points  of the spline, in order; the parameter of the sections is the length of the polygon through them
/// @param exact   the points are those of a drawing
void markMissing(const std::vector<SampledPoint>& points, bool exact, std::vector<ProfileSection>& sections);
}  // namespace wheel_rail_contact::core
