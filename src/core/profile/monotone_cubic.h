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
}  // namespace wheel_rail_contact::core
