// SPDX-License-Identifier: BSD-3-Clause
#include "pressure_measures.h"

namespace wheel_rail_contact
{
void measure(const Grid& grid, PatchPressure& patch)
{
  const Eigen::ArrayXXd& p = patch.pressure;
  patch.force = p.sum() * grid.cellArea();
  patch.max_pressure = p.maxCoeff();
  patch.area = static_cast<double>((p > 0).count()) * grid.cellArea();
  const bool ends = (p.row(p.rows() - 1) > 0).any() || (!grid.symmetric && (p.row(0) > 0).any());
  patch.touches_border = ends || (p.col(0) > 0).any() || (p.col(p.cols() - 1) > 0).any();
}
}  // namespace wheel_rail_contact
