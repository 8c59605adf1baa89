// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace wheel_rail_contact::core
{
/// Root of `f` between `a` and `b`, where f(a) = value_a and f(b) = value_b have opposite signs.
///
/// Illinois form of regula falsi (Dowell & Jarratt 1971). A bisection follows if three steps have not halved the
/// bracket. Ends when the bracket or the last step is below `tolerance`, at an exact zero, or after 100 evaluations.
template <typename Function>
double bracketedRoot(Function f, double a, double value_a, double b, double value_b, double tolerance)
{
  double width_before = std::abs(b - a);
  for (int i = 0; i < 100 && std::abs(b - a) > tolerance && value_b != 0; ++i)
  {
    const bool slow = i % 3 == 2 && std::abs(b - a) > 0.5 * width_before;
    if (i % 3 == 2)
    {
      width_before = std::abs(b - a);
    }
    double x = slow ? 0.5 * (a + b) : (a * value_b - b * value_a) / (value_b - value_a);
    const double value = f(x);
    if ((value > 0) != (value_b > 0))
    {
      a = b;
      value_a = value_b;
    }
    else
    {
      value_a *= 0.5;
    }
    const bool settled = std::abs(x - b) < tolerance && !slow;
    b = x;
    value_b = value;
    if (settled)
    {
      break;
    }
  }
  return b;
}
}  // namespace wheel_rail_contact::core
