// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/point_force_bias.h"

#include <algorithm>
#include <cmath>

#include "core/normal/estimate/patch_errors.h"
#include "core/normal/operator/influence.h"
#include "core/pi.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Errors per unit of the bias over the approach [-].
constexpr ErrorEstimate errors_per_bias{1.4, 3.2, 0.9};
}  // namespace

double pointForceBias(const PatchPressure& pressure, double modulus)
{
  const Grid& grid = pressure.grid;
  Eigen::Index row = 0, column = 0;
  pressure.pressure.maxCoeff(&row, &column);
  const double x = grid.x(static_cast<int>(row)), y = grid.y(static_cast<int>(column));
  const auto difference = [&](double along, double across)
  {
    return influence(Kernel::rectangle, along, across, grid.dx, grid.dy) -
           influence(Kernel::point_force, along, across, grid.dx, grid.dy);
  };
  double sum = 0;
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.rows(); ++i)
    {
      const double p = pressure.pressure(i, j), across = grid.y(j) - y;
      if (p > 0)
      {
        sum += p * (difference(grid.x(i) - x, across) + (grid.symmetric ? difference(grid.x(i) + x, across) : 0));
      }
    }
  }
  return std::abs(sum) / (pi * modulus);
}

ErrorEstimate pointForceErrors(const NormalProblem& problem, const NormalSolution& solution, std::size_t patch)
{
  double bias = 0;  // of the common approach: that of the worst patch
  for (const PatchPressure& each : solution.patches)
  {
    bias = std::max(bias, each.force > 0 ? pointForceBias(each, problem.modulus) : 0);
  }
  bias /= ownApproach(problem, solution, patch);
  return {errors_per_bias.max_pressure * bias, errors_per_bias.area * bias, errors_per_bias.approach * bias};
}
}  // namespace wheel_rail_contact::core
