// SPDX-License-Identifier: BSD-3-Clause
#include "pressure_measures.h"

#include <algorithm>

#include "crest_pressure.h"
#include "pressure_crests.h"

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
  visitCrests(p,
              [&](Eigen::Index column, bool)
              {
                Eigen::Index row = 0;
                p.col(column).maxCoeff(&row);
                patch.max_pressure = std::max(patch.max_pressure, crestPressure(gap, modulus, p, row, column));
              });

  const bool ends = p.row(p.rows() - 1).maxCoeff() > 0 || (!grid.symmetric && p.row(0).maxCoeff() > 0);
  patch.touches_border = ends || p.col(0).maxCoeff() > 0 || p.col(p.cols() - 1).maxCoeff() > 0;
}
}  // namespace wheel_rail_contact
