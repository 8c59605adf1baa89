// SPDX-License-Identifier: BSD-3-Clause
#include "patch_fields.h"

#include <cmath>

namespace wheel_rail_contact
{
namespace
{
const double kPi = std::acos(-1.0);

bool isValid(const PatchGap& patch)
{
  const Grid& grid = patch.grid;
  const bool shaped = grid.nx >= 2 && grid.ny >= 2 && !(grid.symmetric && grid.nx % 2 != 0) &&
                      patch.gap.rows() == grid.rows() && patch.gap.cols() == grid.ny;
  const bool sized = grid.dx > 0 && grid.dy > 0 && std::isfinite(grid.dx) && std::isfinite(grid.dy);
  const bool weighted = patch.weight > 0 && std::isfinite(patch.weight);
  return shaped && sized && weighted && (patch.gap * 0 == 0).all();
}
}  // namespace

bool isValid(const NormalProblem& problem)
{
  const bool load = problem.control == NormalProblem::Control::load;
  bool valid = !problem.patches.empty() && problem.modulus > 0 && std::isfinite(problem.modulus) &&
               std::isfinite(problem.value) && (!load || problem.value > 0);
  for (const PatchGap& patch : problem.patches)
  {
    valid = valid && isValid(patch);
  }
  return valid;
}

int layOut(const NormalProblem& problem, OperatorCache& cache, std::vector<PatchLayout>& patches)
{
  patches.resize(problem.patches.size());
  int length = 0;
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    PatchLayout& patch = patches[k];
    patch.grid = problem.patches[k].grid;
    patch.influence = cache.find(patch.grid.nx, patch.grid.ny, patch.grid.symmetric, patch.grid.dx / patch.grid.dy);
    patch.begin = length;
    patch.size = patch.influence->fieldSize();
    patch.compliance = patch.grid.dy / (kPi * problem.modulus);
    patch.weight = problem.patches[k].weight;
    patch.cell_area = patch.grid.cellArea();
    length += patch.size;
  }
  return length;
}

void toField(const PatchLayout& patch, const Eigen::ArrayXXd& values, double* field)
{
  for (int row = 0; row < patch.grid.rows(); ++row)
  {
    for (int column = 0; column < patch.grid.ny; ++column)
    {
      field[patch.begin + patch.influence->index(row, column)] = values(row, column);
    }
  }
}

void fromField(const PatchLayout& patch, const double* field, Eigen::ArrayXXd& values)
{
  values.resize(patch.grid.rows(), patch.grid.ny);
  for (int row = 0; row < patch.grid.rows(); ++row)
  {
    for (int column = 0; column < patch.grid.ny; ++column)
    {
      values(row, column) = field[patch.begin + patch.influence->index(row, column)];
    }
  }
}
}  // namespace wheel_rail_contact
