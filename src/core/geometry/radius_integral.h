// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "wheel_rail_contact/core/contact_geometry.h"

namespace wheel_rail_contact::core
{
/// Interval of the lateral displacement [m].
struct DisplacementRange
{
  double begin = 0, end = 0;

  double width() const { return end - begin; }
  bool contains(const DisplacementRange& other) const { return begin <= other.begin && other.end <= end; }
};

/// The radius difference as straight lines between the points of a curve, with its integral S [m²] and the integral of
/// the wave between two turning points.
class RadiusIntegral
{
 public:
  /// @throw std::invalid_argument if y decreases.
  explicit RadiusIntegral(std::vector<RadiusDifference> curve);

  /// Range of the curve; empty if it has fewer than two points.
  DisplacementRange range() const;
  /// True if the radius difference has a zero at which it grows with y.
  bool hasCentre() const;
  /// S from the begin of the range to y [m²].
  double at(double y) const;
  /// Widest range over which the radius difference is at most `threshold` [m].
  DisplacementRange widestFlat(double threshold) const;
  /// Integral of dy / sqrt(S(end) - S(y)) over a wave [-]; infinite if S(y) reaches S(end) before the end. S(begin) and
  /// S(end) must be equal.
  double overWave(const DisplacementRange& wave) const;

 private:
  RadiusDifference pointAt(double y) const;
  std::size_t segmentAt(double y) const;

  std::vector<RadiusDifference> curve_;
  std::vector<double> sum_;  ///< S at the points
};
}  // namespace wheel_rail_contact::core
