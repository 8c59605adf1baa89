// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/pressure_measures.h"

#include <algorithm>

#include "core/normal/measures/discontinuity_bias.h"
#include "core/normal/measures/peak_pressure.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Largest correction for curvature discontinuities, as a share of the area. On 4500 gaps with such discontinuities it
/// was up to 0.09.
constexpr double most_at_discontinuities = 0.15;
}  // namespace

void PressureMeasures::measure(const PatchGap& gap, double modulus, PatchPressure& patch)
{
  const Grid& grid = patch.grid;
  const Eigen::ArrayXXd& p = patch.pressure;
  patch.force = p.sum() * grid.cellArea();

  patch.max_pressure = 0;
  visitPeaks(grid, p,
             [&](const CellsAround& peak, bool)
             { patch.max_pressure = std::max(patch.max_pressure, peakPressure(gap, modulus, peak)); });

  polygon_.frame(p, grid.symmetric);
  const double smooth = polygon_.cells(grid.dx / grid.dy), most = most_at_discontinuities * smooth;
  const DiscontinuitySums discontinuities = sumAtDiscontinuities({polygon_, gap, modulus, patch.max_pressure});
  patch.area = (smooth - std::clamp(discontinuities.bias, -most, most)) * grid.cellArea();
  patch.moved_at_discontinuities = discontinuities.sizes * grid.cellArea();

  const bool ends = p.row(p.rows() - 1).maxCoeff() > 0 || (!grid.symmetric && p.row(0).maxCoeff() > 0);
  patch.touches_border = ends || p.col(0).maxCoeff() > 0 || p.col(p.cols() - 1).maxCoeff() > 0;
}
}  // namespace wheel_rail_contact::core
