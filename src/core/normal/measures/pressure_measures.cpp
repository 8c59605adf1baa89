// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/measures/pressure_measures.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
/// Largest correction for curvature discontinuities, as a share of the area. On 4500 gaps with such discontinuities it
/// was up to 0.09.
constexpr double most_at_discontinuities = 0.15;

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
  patch.axis_ratio = polygon_.gyrationRatio() * grid.dx / grid.dy;

  const bool ends = p.row(p.rows() - 1).maxCoeff() > 0 || (!grid.symmetric && p.row(0).maxCoeff() > 0);
  patch.touches_border = ends || p.col(0).maxCoeff() > 0 || p.col(p.cols() - 1).maxCoeff() > 0;
}

void PressureMeasures::measureRatio(PatchPressure& patch)
{
  polygon_.frame(patch.pressure, patch.grid.symmetric);
  polygon_.chords();
  patch.axis_ratio = polygon_.gyrationRatio() * patch.grid.dx / patch.grid.dy;
}

SemiAxes equalEllipse(const PatchPressure& patch)
{
  const double ratio = patch.axis_ratio;
  return ratio > 0 ? SemiAxes{std::sqrt(patch.area / pi * ratio), std::sqrt(patch.area / pi / ratio)} : SemiAxes{};
}

double punchStiffness(const SemiAxes& axes, double modulus)
{
  const double longer = std::max(axes.along, axes.across), shorter = std::min(axes.along, axes.across);
  return shorter > 0 ? pi * modulus * longer / elliptic(shorter / longer).k : 0;
}

Elliptic elliptic(double kappa)
{
  double mean = 0.5 * (1 + kappa), root = std::sqrt(kappa);
  double c = 0.5 * (1 - kappa);
  // Sum of 2^n c_n² over c_0² = k², with c_1² / k² = (1 - kappa) / (4 (1 + kappa)).
  double share = 1 + 0.5 * (1 - kappa) / (1 + kappa);
  const double modulus_squared = (1 - kappa) * (1 + kappa);
  for (double power = 4; c * c > 1e-17 * mean * mean; power *= 2)
  {
    const double next = 0.5 * (mean + root);
    root = std::sqrt(mean * root);
    c = 0.25 * c * c / next;
    mean = next;
    share += modulus_squared > 0 ? power * c * c / modulus_squared : 0;
  }
  Elliptic result;
  result.k = 0.5 * pi / mean;
  result.d = 0.5 * result.k * share;
  return result;
}
}  // namespace wheel_rail_contact::core
