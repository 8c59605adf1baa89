// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/profile/profile_measures.h"

namespace wheel_rail_contact::core
{
/// Points of a profile of one part, from which readProfile() makes the same curve again, as closely as `spacing`
/// permits.
///
/// They are at most `spacing` apart and include all section boundaries; closer, down to 0.06 mm, where the radius is
/// below 10 spacings, and near ends, discontinuities of the curvature and missing points, at which an interpolating
/// spline deviates. Ranges of missing points stay without points.
/// @param spacing  at least 0.06 mm [m]
std::vector<ProfilePlace> pointsAlong(const Profile& profile, double spacing = 0.2e-3);

/// Largest distance of a profile from another one, across the other one, where no points of either are missing [m].
double largestDistance(const Profile& profile, const Profile& other);
}  // namespace wheel_rail_contact::core
