// SPDX-License-Identifier: BSD-3-Clause
#include "pressure_measures.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
/// Rise of the parabola through three squared pressures above the middle one, which is the highest; zero at an edge.
double rise(double before, double top, double after)
{
  const double slope = (after - before) * (after + before);
  const double bend = 2 * top * top - before * before - after * after;
  return bend > 0 && before > 0 && after > 0 ? slope * slope / (8 * bend) : 0;
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
  patch.max_pressure = std::sqrt(top * top + rise(peak[-1], top, peak[1]) + rise(peak[-column], top, peak[column]));

  const bool ends = p.row(p.rows() - 1).maxCoeff() > 0 || (!grid.symmetric && p.row(0).maxCoeff() > 0);
  patch.touches_border = ends || p.col(0).maxCoeff() > 0 || p.col(p.cols() - 1).maxCoeff() > 0;
}
}  // namespace wheel_rail_contact
