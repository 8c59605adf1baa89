// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/profile/smoothing_spline.h"

namespace wheel_rail_contact::core
{
/// Distances along the polygon through the points, from the first [m]; strictly growing.
/// @throw std::invalid_argument if there are fewer than 4 points, one is not finite or has no positive weight, two
/// neighbours are equal, or the polygon is longer than 10 m.
std::vector<double> polygonLength(const std::vector<SampledPoint>& points);
}  // namespace wheel_rail_contact::core
