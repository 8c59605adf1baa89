// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/profile/smoothing_spline.h"

namespace wheel_rail_contact::core
{
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
