// SPDX-License-Identifier: BSD-3-Clause
#include "pressure_measures.h"

#include <algorithm>
#include <cmath>

#include "contact_edge.h"

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

void frame(const Grid& grid, const Eigen::ArrayXXd& pressure, Eigen::ArrayXXd& framed)
{
  const Eigen::Index rows = pressure.rows(), columns = pressure.cols();
  framed.resize(rows + 2 * kFrame, columns + 2 * kFrame);
  framed.leftCols<kFrame>().setZero();
  framed.rightCols<kFrame>().setZero();
  framed.topRows<kFrame>().setZero();
  framed.bottomRows<kFrame>().setZero();
  framed.block(kFrame, kFrame, rows, columns) = pressure;
  for (Eigen::Index i = 0; grid.symmetric && i < std::min<Eigen::Index>(kFrame, rows); ++i)
  {
    framed.row(kFrame - 1 - i) = framed.row(kFrame + i);
  }
}
}  // namespace

void PressureMeasures::measure(PatchPressure& patch)
{
  const Grid& grid = patch.grid;
  const Eigen::ArrayXXd& p = patch.pressure;
  frame(grid, p, framed_);
  patch.force = p.sum() * grid.cellArea();
  patch.area = contactCells(framed_, grid.symmetric) * grid.cellArea();

  Eigen::Index i = 0, j = 0;
  const double top = p.maxCoeff(&i, &j);
  const double* peak = framed_.data() + (i + kFrame) + (j + kFrame) * framed_.rows();
  const Eigen::Index column = framed_.rows();
  patch.max_pressure = std::sqrt(top * top + rise(peak[-1], top, peak[1]) + rise(peak[-column], top, peak[column]));

  const bool ends = p.row(p.rows() - 1).maxCoeff() > 0 || (!grid.symmetric && p.row(0).maxCoeff() > 0);
  patch.touches_border = ends || p.col(0).maxCoeff() > 0 || p.col(p.cols() - 1).maxCoeff() > 0;
}
}  // namespace wheel_rail_contact
