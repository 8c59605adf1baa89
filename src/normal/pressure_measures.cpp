// SPDX-License-Identifier: BSD-3-Clause
#include "pressure_measures.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
/// How much three squared pressures bend down, the middle one being the highest [Pa²].
double bendOf(double before, double top, double after)
{
  return 2 * top * top - before * before - after * after;
}

/// Rise of the parabola through three squared pressures above the middle one, which is the highest; zero at an edge.
double rise(double before, double top, double after)
{
  const double slope = (after - before) * (after + before);
  const double bend = bendOf(before, top, after);
  return bend > 0 && before > 0 && after > 0 ? slope * slope / (8 * bend) : 0;
}

/// By how much cells hold more than the highest pressure, over it [-]. `bend` is bendOf() along and across, over the
/// highest cell's square [-].
///
/// A constant pressure on a cell that has to meet the contact condition in its centre exceeds the pressure there by
/// size² / 24 times the pressure's own bend (to first order, for waves of any direction: the mean of the influence over
/// a cell is that much less than in its centre): `bend` / 48. A smaller approach takes part of it back. Fitted to 4 651
/// patches of test/calibration's scenes against cells four times finer each way; on as many others it left 25 % of the
/// error in the median, 40 % in the mean. Cells so few that `bend` is above 1 tell no more than that.
double excess(double bend)
{
  const double told = std::min(bend, 1.0);
  return told * (0.011 + 0.018 * told);
}
}  // namespace

void PressureMeasures::measure(PatchPressure& patch)
{
  const Grid& grid = patch.grid;
  const Eigen::ArrayXXd& p = patch.pressure;
  polygon_.frame(p, grid.symmetric);
  patch.force = p.sum() * grid.cellArea();
  patch.area = polygon_.cells(grid.dx / grid.dy) * grid.cellArea();

  Eigen::Index i = 0, j = 0;
  const double top = p.maxCoeff(&i, &j);
  const double* peak = polygon_.at(i, j);
  const std::ptrdiff_t column = polygon_.stride();
  const double bend = (bendOf(peak[-1], top, peak[1]) + bendOf(peak[-column], top, peak[column])) / (top * top);
  const double highest = std::sqrt(top * top + rise(peak[-1], top, peak[1]) + rise(peak[-column], top, peak[column]));
  patch.max_pressure = top > 0 ? std::max((1 - excess(bend)) * highest, top) : 0;

  const bool ends = p.row(p.rows() - 1).maxCoeff() > 0 || (!grid.symmetric && p.row(0).maxCoeff() > 0);
  patch.touches_border = ends || p.col(0).maxCoeff() > 0 || p.col(p.cols() - 1).maxCoeff() > 0;
}
}  // namespace wheel_rail_contact
