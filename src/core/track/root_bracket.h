// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
/// Bracket of a zero of a falling function of one variable, which Newton's method approaches.
///
/// A Newton step is replaced where it leaves the bracket, or where the last one did not halve the function: by the
/// regula falsi with halved ordinates (Illinois method, Dowell and Jarratt 1971), and by bisection where this did not
/// halve it either.
class RootBracket
{
 public:
  /// Adds a value of the function. A value of zero adds nothing.
  void add(double x, double value);
  /// Where the function is to be evaluated next.
  /// @param x     place of the last value
  /// @param step  Newton step from there
  double next(double x, double step) const;
  /// True between the ends.
  bool contains(double x) const { return x > least_ && x < most_; }
  /// Distance of the ends; infinite until both are known.
  double width() const { return most_ - least_; }

 private:
  double least_ = -infinity, most_ = infinity;  ///< ends
  double at_least_ = 0, at_most_ = 0;           ///< ordinates there, halved where an end stays
  double last_ = infinity;                      ///< absolute last value
  int slow_ = 0;                                ///< number of last values that were not halved
};

/// Root of `f` between `a` and `b`, where f(a) = value_a and f(b) = value_b have opposite signs: the last place
/// at which `f` was evaluated. Ends when the bracket or the last step is below `tolerance`, at an exact zero, or after
/// 100 evaluations.
template <typename Function>
double bracketedRoot(Function f, double a, double value_a, double b, double value_b, double tolerance)
{
  const double sign = (value_a > value_b) == (a < b) ? 1 : -1;
  RootBracket bracket;
  bracket.add(a, sign * value_a);
  bracket.add(b, sign * value_b);
  double x = b, step = infinity, value = value_b;
  for (int i = 0; i < 100 && bracket.width() > tolerance && std::abs(step) >= tolerance && value != 0; ++i)
  {
    step = bracket.next(x, infinity) - x;  // there is no Newton step
    x += step;
    value = f(x);
    bracket.add(x, sign * value);
  }
  return x;
}
}  // namespace wheel_rail_contact::core
