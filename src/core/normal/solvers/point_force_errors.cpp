// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/seidel.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/normal/operator/influence.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Errors per unit of the bias over the approach [-].
constexpr ErrorEstimate errors_per_bias{1.4, 3.2, 0.9};

/// Absolute difference between the displacement of the highest cell by forces at the cell centres (Kernel::point_force)
/// and that by the pressure itself [m]. `modulus`: contact modulus E* [Pa].
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

/// Smallest box of cells around a pressure; size in cells of the whole grid.
struct LoadedBox
{
  int rows = 0, columns = 0;
};

LoadedBox loadedBox(const Grid& grid, const double* p)
{
  const int rows = grid.rows();
  int first_row = rows, last_row = -1, first_column = grid.ny, last_column = -1;
  for (int cell = 0; cell < rows * grid.ny; ++cell)
  {
    if (p[cell] > 0)
    {
      first_row = std::min(first_row, cell % rows);
      last_row = std::max(last_row, cell % rows);
      first_column = std::min(first_column, cell / rows);
      last_column = std::max(last_column, cell / rows);
    }
  }
  const int height = grid.symmetric ? 2 * (last_row + 1) : last_row - first_row + 1;
  return last_row < 0 ? LoadedBox() : LoadedBox{height, last_column - first_column + 1};
}
}  // namespace

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

double stripeEnergy(const Grid& grid, const double* pressure)
{
  const LoadedBox box = loadedBox(grid, pressure);
  double energy = 0;
  for (int column = 0; column < box.columns; ++column)
  {
    for (int row = 0; row < box.rows; ++row)
    {
      const double pairs = (row > 0 ? 2.0 : 1.0) * (column > 0 ? 2.0 : 1.0) * (box.rows - row) * (box.columns - column);
      const double sign = column % 2 == 0 ? 1 : -1;
      energy += sign * pairs * pointInfluence(row * grid.dx, column * grid.dy, grid.dx, grid.dy);
    }
  }
  return energy;
}
}  // namespace wheel_rail_contact::core
