// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// How much three squared pressures bend down, the middle one being the highest [Pa²].
inline double bendOf(double before, double top, double after)
{
  return 2 * top * top - before * before - after * after;
}

/// Rise of the parabola through three squared pressures above the middle one, which is the highest; zero at an edge
/// [Pa²].
inline double riseOf(double before, double top, double after)
{
  const double slope = (after - before) * (after + before);
  const double bend = bendOf(before, top, after);
  return bend > 0 && before > 0 && after > 0 ? slope * slope / (8 * bend) : 0;
}

/// A line of cells through a crest; cells beyond the grid carry nothing, those beyond x = 0 of a symmetric grid are
/// the mirror image.
class CrestLine
{
 public:
  CrestLine(const double* first, Eigen::Index stride, Eigen::Index size, Eigen::Index crest, bool mirrored)
      : first_(first), stride_(stride), size_(size), crest_(crest), mirrored_(mirrored), top_(first[crest * stride])
  {
  }

  /// Pressure over the crest's, `offset` cells from there.
  double p(Eigen::Index offset) const
  {
    Eigen::Index place = crest_ + offset;
    place = mirrored_ && place < 0 ? -1 - place : place;
    return place >= 0 && place < size_ ? first_[place * stride_] / top_ : 0;
  }
  /// Both cells beside the crest are loaded.
  bool isInside() const { return p(-1) > 0 && p(1) > 0; }
  double bend() const { return bendOf(p(-1), p(0), p(1)); }
  double rise() const { return riseOf(p(-1), p(0), p(1)); }

 private:
  const double* first_;
  Eigen::Index stride_, size_, crest_;
  bool mirrored_;
  double top_;
};

/// The lines of cells through a crest, along and across.
inline std::array<CrestLine, 2> linesThrough(const Grid& grid, const Eigen::ArrayXXd& pressure, Eigen::Index row,
                                             Eigen::Index column)
{
  return {CrestLine(pressure.data() + column * pressure.rows(), 1, pressure.rows(), row, grid.symmetric),
          CrestLine(pressure.data() + row, pressure.rows(), pressure.cols(), column, false)};
}

/// Calls `visit(column, rises)` for each loaded column whose highest cell neither neighbouring column's exceeds;
/// `rises` if it exceeds that of the column before: of columns that are equally high only the first does.
template <typename Visit>
void visitCrests(const Eigen::ArrayXXd& pressure, Visit visit)
{
  double before = 0, here = pressure.col(0).maxCoeff();
  for (Eigen::Index j = 0; j < pressure.cols(); ++j)
  {
    const double after = j + 1 < pressure.cols() ? pressure.col(j + 1).maxCoeff() : 0;
    if (here > 0 && here >= before && here >= after)
    {
      visit(j, here > before);
    }
    before = here;
    here = after;
  }
}
}  // namespace wheel_rail_contact
