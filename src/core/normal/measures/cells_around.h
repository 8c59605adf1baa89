// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Cells around a pressure peak: a loaded cell whose pressure no neighbour exceeds. Offsets are counted in cells from
/// the peak. Cells outside the grid have no pressure; cells beyond x = 0 of a symmetric grid are the mirror image.
/// Keeps a reference to the pressure.
class CellsAround
{
 public:
  using Index = Eigen::Index;

  CellsAround(const Grid& grid, const Eigen::ArrayXXd& pressure, Index row, Index column)
      : pressure_(pressure), mirrored_(grid.symmetric), row_(row), column_(column), top_(pressure(row, column))
  {
  }
  CellsAround(const Grid&, Eigen::ArrayXXd&&, Index, Index) = delete;

  Index row() const { return row_; }
  Index column() const { return column_; }
  /// Pressure of the peak cell [Pa].
  double top() const { return top_; }
  bool inGrid(Index along, Index across) const
  {
    const Index row = rowAt(along), column = column_ + across;
    return row >= 0 && row < pressure_.rows() && column >= 0 && column < pressure_.cols();
  }
  /// Pressure over that of the peak cell [-].
  double p(Index along, Index across) const
  {
    return inGrid(along, across) ? pressure_(rowAt(along), column_ + across) / top_ : 0;
  }

  /// True if both neighbours of the peak across the track are loaded.
  bool isInside() const { return p(0, -1) > 0 && p(0, 1) > 0; }
  /// True if one of these neighbours is the outermost loaded cell of the row.
  bool isBesideEnd() const { return isInside() && !(p(0, -2) > 0 && p(0, 2) > 0); }
  /// Offset of the outermost loaded cell from the peak along the track, in the `outward` direction (+1 or -1).
  Index tip(Index outward) const
  {
    Index last = 0;
    while (p(last + outward, 0) > 0)
    {
      last += outward;
    }
    return last;
  }
  /// True if the border of the grid cuts the pressure along the track.
  bool isCutAlong() const { return isCutAt(-1) || isCutAt(1); }

  /// Bend at the peak: negative second difference of the squared pressure over the squared peak [-]. Along the track,
  /// and the sum of along and across.
  double bendAlong() const { return bendOf(p(-1, 0), p(1, 0)); }
  double bend() const { return bendAlong() + bendOf(p(0, -1), p(0, 1)); }
  /// Error of the parabola across that the third differences show [-] (doc/theory.md, "Peaks near an end").
  double errorAcross() const
  {
    constexpr double share = 0.064;  // 1 / (9 sqrt(3))
    const double near = std::pow(p(0, -1), 2), far = std::pow(p(0, 1), 2);
    const double before = far - 3 + 3 * near - std::pow(p(0, -2), 2), after = near - 3 + 3 * far - std::pow(p(0, 2), 2);
    return 0.5 * share * (std::abs(before) + std::abs(after));
  }
  /// Maximum of the parabolas through the squared pressures along and across [Pa].
  double parabolas() const { return top_ * std::sqrt(1 + riseOf(p(-1, 0), p(1, 0)) + riseOf(p(0, -1), p(0, 1))); }

 private:
  /// True if the pressure reaches the border and decreases less steeply there than it does at its edge.
  bool isCutAt(Index outward) const
  {
    constexpr double steepest = 0.75;  // ratio for an edge beyond the centre of the next cell
    const Index last = tip(outward);
    return !inGrid(last + outward, 0) && p(last, 0) > steepest * p(last - outward, 0);
  }
  static double bendOf(double before, double after) { return 2 - before * before - after * after; }
  /// Rise of the parabola through three squared pressures above the middle one; zero at an edge.
  static double riseOf(double before, double after)
  {
    const double slope = (after - before) * (after + before), bend = bendOf(before, after);
    return bend > 0 && before > 0 && after > 0 ? slope * slope / (8 * bend) : 0;
  }
  Index rowAt(Index along) const
  {
    const Index row = row_ + along;
    return mirrored_ && row < 0 ? -1 - row : row;
  }

  const Eigen::ArrayXXd& pressure_;
  bool mirrored_;
  Index row_, column_;
  double top_;
};

/// Calls `visit(peak, rises)` for the highest cell of each loaded column, unless a neighbouring column has a higher
/// one. `rises` is true if the column exceeds the previous one. Of several columns of equal height only the first
/// rises.
template <typename Visit>
void visitPeaks(const Grid& grid, const Eigen::ArrayXXd& pressure, Visit visit)
{
  double before = 0, here = pressure.col(0).maxCoeff();
  for (Eigen::Index j = 0; j < pressure.cols(); ++j)
  {
    const double after = j + 1 < pressure.cols() ? pressure.col(j + 1).maxCoeff() : 0;
    if (here > 0 && here >= before && here >= after)
    {
      Eigen::Index row = 0;
      pressure.col(j).maxCoeff(&row);
      visit(CellsAround(grid, pressure, row, j), here > before);
    }
    before = here;
    here = after;
  }
}
}  // namespace wheel_rail_contact::core
