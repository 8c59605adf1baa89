// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
}  // namespace wheel_rail_contact::core
