// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/profile/smoothing_spline.h"

namespace wheel_rail_contact::core
{
/// Distance of each point from the first one, along the polygon through the points [m]; strictly increasing.
/// @throw std::invalid_argument if there are fewer than 4 points, a point is not finite or has no positive weight, two
/// neighbouring points are equal, or the polygon is longer than 10 m.
std::vector<double> polygonLength(const std::vector<SampledPoint>& points);
}  // namespace wheel_rail_contact::core
