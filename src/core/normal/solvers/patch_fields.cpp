// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/patch_fields.h"

#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
bool isValid(const PatchGap& patch)
{
  const Grid& grid = patch.grid;
  const bool shaped = grid.nx >= 2 && grid.ny >= 2 && !(grid.symmetric && grid.nx % 2 != 0) &&
                      patch.gap.rows() == grid.rows() && patch.gap.cols() == grid.ny;
  const bool sized = grid.dx > 0 && grid.dy > 0 && std::isfinite(grid.dx) && std::isfinite(grid.dy);
  const bool weighted = patch.weight > 0 && std::isfinite(patch.weight);
  // Zero times a value that is not finite is NaN, and so is the sum.
  return shaped && sized && weighted && (patch.gap * 0).sum() == 0;
}

/// Writes value(row, column) to the cells of the patch in a field, in the order of its operator.
template <typename Value>
void fillCells(const PatchLayout& patch, Value value, LaneBuffer& field)
{
  for (int row = 0; row < patch.grid.rows(); ++row)
  {
    double* line = field.data() + patch.begin + patch.influence->rowOffset(row);
    for (int column = 0; column < patch.grid.ny; ++column)
    {
      line[patch.influence->columnOffset(column)] = value(row, column);
    }
  }
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

bool hasValidSurface(const CurvedProblem& problem)
{
  bool valid = problem.normals.empty() || problem.normals.size() == problem.patches.size();
  Eigen::Index columns = 0;
  for (std::size_t k = 0; k < problem.patches.size(); ++k)
  {
    const int count = problem.patches[k].grid.ny;
    columns += count;
    if (valid && !problem.normals.empty())
    {
      const auto& [weight, turn] = problem.normals[k];
      valid = (weight.size() == 0 || weight.size() == count) && (turn.size() == 0 || turn.size() == count) &&
              (weight > 0).all() && weight.isFinite().all() && turn.isFinite().all();
    }
  }
  const Eigen::MatrixXd& coupling = problem.coupling;
  return valid &&
         (!problem.isCoupled() || (coupling.rows() == columns && coupling.cols() == columns && coupling.allFinite()));
}

int layOut(const NormalProblem& problem, OperatorCache* cache, std::vector<PatchLayout>& patches)
{
  patches.resize(problem.patches.size());
  int length = 0;
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    PatchLayout& patch = patches[k];
    const Grid& grid = problem.patches[k].grid;
    patch.grid = grid;
    patch.influence = cache ? cache->find(grid.nx, grid.ny, grid.symmetric, grid.dx / grid.dy) : nullptr;
    patch.begin = length;
    patch.size = cache ? patch.influence->fieldSize() : roundUpToLanes(grid.rows() * grid.ny);
    patch.weight = problem.patches[k].weight;
    patch.stiffness = pi * problem.modulus / patch.grid.dy;
    patch.force = patch.stiffness * patch.grid.cellArea();
    patch.least_gap = problem.patches[k].gap.minCoeff();
    length += patch.size;
  }
  return length;
}

void toField(const PatchLayout& patch, double factor, const Eigen::ArrayXXd& values, LaneBuffer& field)
{
  if (!patch.influence)
  {
    Eigen::Map<Eigen::ArrayXXd>(field.data() + patch.begin, patch.grid.rows(), patch.grid.ny) = factor * values;
    return;
  }
  fillCells(
      patch, [&](int row, int column) { return factor * values(row, column); }, field);
}

void columnsToField(const PatchLayout& patch, const Eigen::Ref<const Eigen::ArrayXd>& values, LaneBuffer& field)
{
  fillCells(
      patch, [&](int /*row*/, int column) { return values(column); }, field);
}

void columnSums(const PatchLayout& patch, const LaneBuffer& field, Eigen::Ref<Eigen::VectorXd> sums)
{
  sums.setZero();
  for (int row = 0; row < patch.grid.rows(); ++row)
  {
    const double* line = field.data() + patch.begin + patch.influence->rowOffset(row);
    for (int column = 0; column < patch.grid.ny; ++column)
    {
      sums[column] += line[patch.influence->columnOffset(column)];
    }
  }
}

void fromField(const PatchLayout& patch, double factor, const LaneBuffer& field, Eigen::ArrayXXd& values)
{
  const int rows = patch.grid.rows(), columns = patch.grid.ny;
  if (!patch.influence)
  {
    values = factor * Eigen::Map<const Eigen::ArrayXXd>(field.data() + patch.begin, rows, columns);
    return;
  }
  values.resize(rows, columns);
  for (int row = 0; row < rows; ++row)
  {
    double* to = values.data() + row;
    const double* line = field.data() + patch.begin + patch.influence->rowOffset(row);
    for (int column = 0; column < columns; ++column)
    {
      to[column * rows] = factor * line[patch.influence->columnOffset(column)];
    }
  }
}
}  // namespace wheel_rail_contact::core
