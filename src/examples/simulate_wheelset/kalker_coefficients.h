// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace simulate_wheelset
{
/// Creepage and spin coefficients of the linear theory of rolling contact [-].
struct KalkerCoefficients
{
  double c11 = 0;  ///< longitudinal creepage to longitudinal force
  double c22 = 0;  ///< lateral creepage to lateral force
  double c23 = 0;  ///< spin to lateral force; with the other sign, lateral creepage to moment
  double c33 = 0;  ///< spin to moment
};

/// The coefficients over the ratio of the semi-axes of an elliptic contact, for one Poisson's ratio.
///
/// Source: Kalker (1990), Three-dimensional elastic bodies in rolling contact, table E3; also in Johnson (1985),
/// Contact mechanics, section 8.4. The table has 19 ratios a/b from 0.1 to 10, and the Poisson's ratios 0, 1/4 and 1/2.
/// Between these, the polynomial of second order through the three values is used.
class KalkerTable
{
 public:
  /// @param poisson Poisson's ratio of both bodies [-], 0 to 0.5
  /// @throw std::invalid_argument if it is out of range.
  explicit KalkerTable(double poisson);

  /// Coefficients at a ratio of the semi-axes. The logarithm of each is linear in that of a/b between the ratios of the
  /// table. Beyond its ends the last line is continued, as the asymptotic formulas are nearly powers of a/b: see
  /// contains().
  /// @param ratio a/b [-], > 0: a along the rolling direction, b across
  KalkerCoefficients at(double ratio) const;

  /// True if the ratio a/b is within the table.
  static bool contains(double ratio);

 private:
  std::vector<std::array<double, 4>> logarithms_;  ///< of c11, c22, c23, c33 at each ratio of the table
};
}  // namespace simulate_wheelset
