// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

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
