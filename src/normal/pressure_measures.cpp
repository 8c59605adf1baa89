// SPDX-License-Identifier: BSD-3-Clause
#include "pressure_measures.h"

#include <algorithm>

#include "crest_pressure.h"

namespace wheel_rail_contact
{
void PressureMeasures::measure(const PatchGap& gap, double modulus, PatchPressure& patch)
{
  const Grid& grid = patch.grid;
  const Eigen::ArrayXXd& p = patch.pressure;
  polygon_.frame(p, grid.symmetric);
  patch.force = p.sum() * grid.cellArea();
  patch.area = polygon_.cells(grid.dx / grid.dy) * grid.cellArea();

  patch.max_pressure = 0;
  visitCrests(grid, p,
              [&](const CellsAround& crest, bool)
              { patch.max_pressure = std::max(patch.max_pressure, crestPressure(gap, modulus, crest)); });

  const bool ends = p.row(p.rows() - 1).maxCoeff() > 0 || (!grid.symmetric && p.row(0).maxCoeff() > 0);
  patch.touches_border = ends || p.col(0).maxCoeff() > 0 || p.col(p.cols() - 1).maxCoeff() > 0;
}
}  // namespace wheel_rail_contact
