// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/profile/smoothing_spline.h"

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
}  // namespace wheel_rail_contact::core
