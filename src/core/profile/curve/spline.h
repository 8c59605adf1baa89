// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core
{
/// Point of a sampled profile, in the profile frame (y to the field side, z up).
struct SampledPoint
{
  double y = 0;          ///< [m]
  double z = 0;          ///< [m]
  double weight = 1;     ///< relative weight of its squared deviation in smoothingSpline() [-], > 0
  std::size_t line = 0;  ///< number of its line in a file, from 1, for messages; 0: none
};

/// Distance between two points [m].
inline double distance(const SampledPoint& a, const SampledPoint& b)
{
  return std::hypot(b.y - a.y, b.z - a.z);
}

/// Distance of each point from the first one, along the polygon through the points [m]; strictly increasing.
/// @throw std::invalid_argument if there are fewer than 4 points, a point is not finite or has no positive weight, two
/// neighbouring points are equal, or the polygon is longer than 10 m.
std::vector<double> polygonLength(const std::vector<SampledPoint>& points);

/// Largest noise that smoothingSpline() accepts [m].
constexpr double max_spline_noise = 1e-4;

/// Parametric natural cubic spline through all points, with one section between neighbouring points. The parameter is
/// the length of the polygon through the points. Weights have no effect.
///
/// Accuracy for points of the standard profiles 0.25 mm apart: the spline reproduces the profile within 1e-7 mm and its
/// curvature within 0.1 %. Within about eight points of a curvature discontinuity the deviation is up to 2e-4 mm, and
/// the discontinuity itself is spread over two or three points.
///
/// @param points  at least 4, in order along the curve, no two neighbours equal; length of the polygon at most 10 m
/// @throw std::invalid_argument if the points violate these rules.
std::vector<ProfileSection> interpolatingSpline(const std::vector<SampledPoint>& points);

/// Means of groups of neighbouring points, with their weights. A group spans less than 0.2 mm. The polygon through
/// dense noisy points is longer than their curve, that through their means is not.
std::vector<SampledPoint> groupedPoints(const std::vector<SampledPoint>& points);

/// Smooth parametric cubic spline near noisy points. Its parameter is that of interpolatingSpline(); its sections are
/// about 0.5 mm long.
///
/// It consists of cubic B-splines with a penalty on the third differences of the coefficients (Eilers and Marx,
/// Flexible smoothing with B-splines and penalties, Statistical Science 11, 1996). A first fit with a uniform penalty
/// gives the local curvature. In the second fit the penalty is inversely proportional to the square of this curvature.
/// A flat crown or tread is therefore smoothed over a greater length than a sharp corner. The strength of the penalty
/// is chosen to make the mean square deviation noise² (Reinsch, Smoothing by spline functions, Numer. Math. 10, 1967).
/// Stretches with a kink do not count in it: there, the penalty is reduced in steps.
///
/// Accuracy for standard profiles sampled every 0.25 mm with white noise of 5 um (with the seed of the test): curvature
/// of crown and tread within about 0.5 1/m (r.m.s.), of a 13 mm corner within 3 1/m of its 77 1/m; shape within 4 um,
/// and 10 um at the ends of the corner. The sections carry the standard deviations of position and curvature.
///
/// @param points  as for interpolatingSpline(), weights > 0
/// @param noise   expected standard deviation of the points across the curve [m], > 0, at most max_spline_noise
/// @throw std::invalid_argument if points or noise violate these rules, or if the curve leaves the points: because of a
/// noise that is not theirs, or where points are missing.
std::vector<ProfileSection> smoothingSpline(const std::vector<SampledPoint>& points, double noise);
}  // namespace wheel_rail_contact::core
