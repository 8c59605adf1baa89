// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wheel_rail_contact::core
{
/// Slope of a monotone cubic at a point between two intervals (Fritsch and Butland 1984, eq. 2.5): zero at an extreme,
/// else a weighted harmonic mean of the slopes of the chords.
inline double monotoneSlope(double before, double after, double width_before, double width_after)
{
  if (!(before * after > 0))
  {
    return 0;
  }
  const double one = 2 * width_after + width_before, other = width_after + 2 * width_before;
  return (one + other) / (one / before + other / after);
}

/// Coefficients of a cubic polynomial c[0] + c[1] t + c[2] t² + c[3] t³ over 0 to `width`, from its values and slopes
/// at both ends (Hermite).
inline void setCubic(double begin, double end, double slope_begin, double slope_end, double width, double (&c)[4])
{
  const double chord = (end - begin) / width;
  c[0] = begin;
  c[1] = slope_begin;
  c[2] = (3 * chord - 2 * slope_begin - slope_end) / width;
  c[3] = (slope_begin + slope_end - 2 * chord) / (width * width);
}
}  // namespace wheel_rail_contact::core
