// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/profile/curve/spline.h"

namespace wheel_rail_contact::core
{
/// Points of a curve with their neighbours at some distance.
class CurveWindows
{
 public:
  /// Neighbours are at least 0.25 mm apart: noise of points that are closer is often correlated. Rounding gives steps,
  /// and a measuring device filters. The four neighbours of a window are at most 12 mm apart: a curve is no cubic over
  /// more.
  static constexpr double least_spacing = 0.25e-3, longest = 12e-3;  ///< [m]

  /// @param points  in order along the curve
  explicit CurveWindows(const std::vector<SampledPoint>& points);

  /// Distance of the points `first` to `last` across the curve from the cubic through two neighbours before and two
  /// after them, and its standard deviation for noise of 1.
  struct Residual
  {
    double across;     ///< of the point that is farthest from the cubic [m], positive to the left of the curve
    double at_first;   ///< of the first point [m]
    double deviation;  ///< [-]
    bool flat;         ///< the curve is flatter than 45 degrees there
    double length;     ///< distance of the two nearest neighbours [m]
    double turn;       ///< angle between the chords of the neighbours on either side [rad]
  };
  /// @return nothing if the curve has no such neighbours
  std::optional<Residual> residual(std::size_t first, std::size_t last) const;
  /// The same of one point, without the neighbours `first` to `last`.
  std::optional<Residual> residualWithout(std::size_t point, std::size_t first, std::size_t last) const;

 private:
  std::size_t before(std::size_t point, std::size_t first, std::size_t last) const;
  std::size_t after(std::size_t point, std::size_t first, std::size_t last) const;
  std::optional<Residual> residual(std::size_t first, std::size_t last, std::size_t skip_first,
                                   std::size_t skip_last) const;

  const std::vector<SampledPoint>& points_;
  std::vector<double> length_;
};
}  // namespace wheel_rail_contact::core
