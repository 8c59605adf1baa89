// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/starting_pressure.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Steps of the search for the interpenetration level; the first guess needs no more.
constexpr int halvings = 12;

bool isLoadControlled(const NormalProblem& problem)
{
  return problem.control == NormalProblem::Control::load;
}

/// Radius of the circle with the area of the cells below `level` [m].
double equivalentRadius(const PatchLayout& patch, const LaneBuffer& gap, double level)
{
  const double cells = laneKernels().count_below(patch.size, level, gap.data() + patch.begin);
  return std::sqrt(cells * patch.grid.cellArea() / pi);
}

/// Load of circular Hertz contacts with the interpenetration areas of the patches [N]. `level` is half the approach: F
/// = 4/3 E* a delta (Johnson 1985, eq. 4.22 to 4.24).
double loadAt(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap,
              double level)
{
  double load = 0;
  for (const PatchLayout& patch : patches)
  {
    const double depth = std::max(patch.weight * level - patch.least_gap, 0.0);
    load += patch.weight * 8 / 3 * problem.modulus * equivalentRadius(patch, gap, patch.weight * level) * depth;
  }
  return load;
}

/// Half the approach that carries the load [m].
double levelForLoad(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap)
{
  double low = firstTouch(patches), high = infinity;
  for (const PatchLayout& patch : patches)
  {
    const double one_cell = patch.weight * problem.modulus * std::sqrt(patch.grid.cellArea());
    high = std::min(high, (patch.least_gap + problem.value / one_cell) / patch.weight);
  }
  for (int halving = 0; halving < halvings; ++halving)
  {
    const double middle = 0.5 * (low + high);
    (loadAt(problem, patches, gap, middle) < problem.value ? low : high) = middle;
  }
  return high;
}

bool hasShape(const Eigen::ArrayXXd& values, const Grid& grid)
{
  return values.rows() == grid.rows() && values.cols() == grid.ny;
}

/// Copies the displacement of an earlier solution on cells of the same aspect. Returns false if it does not belong to
/// the pressure.
bool copyDisplacement(const PatchLayout& patch, const PatchPressure& earlier, const LaneBuffer& pressure,
                      LaneBuffer& displacement)
{
  if (!patch.influence || !hasShape(earlier.displacement, patch.grid) || !(earlier.grid.dy > 0))
  {
    return false;
  }
  // The same pressures on cells of another size cause proportional displacements.
  toField(patch, patch.grid.dy / earlier.grid.dy, earlier.displacement, displacement);
  return patch.influence->isProduct(pressure.data() + patch.begin, displacement.data() + patch.begin);
}
}  // namespace

double firstTouch(const std::vector<PatchLayout>& patches)
{
  double level = infinity;
  for (const PatchLayout& patch : patches)
  {
    level = std::min(level, patch.least_gap / patch.weight);
  }
  return level;
}

double approachForLoad(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap)
{
  return 2 * levelForLoad(problem, patches, gap) - firstTouch(patches);
}

double loadOf(const std::vector<PatchLayout>& patches, const LaneBuffer& pressure)
{
  double load = 0;
  for (const PatchLayout& patch : patches)
  {
    load += patch.weight * patch.force * laneKernels().sum(patch.size, pressure.data() + patch.begin);
  }
  return load;
}

void scaleToLoad(const NormalProblem& problem, const std::vector<PatchLayout>& patches, LaneBuffer& pressure,
                 LaneBuffer* displacement)
{
  const double factor = problem.value / loadOf(patches, pressure);
  for (const PatchLayout& patch : patches)
  {
    laneKernels().scale(patch.size, factor, pressure.data() + patch.begin);
    if (displacement)
    {
      laneKernels().scale(patch.size, factor, displacement->data() + patch.begin);
    }
  }
}

Start warmStart(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const NormalSolution& earlier,
                LaneBuffer& pressure, LaneBuffer& displacement)
{
  bool complete = true;
  for (std::size_t k = 0; k < patches.size(); ++k)
  {
    const PatchPressure& known = earlier.patches[k];
    if (!hasShape(known.pressure, patches[k].grid) || !(known.pressure.minCoeff() >= 0))
    {
      return Start::none;
    }
    toField(patches[k], 1 / patches[k].stiffness, known.pressure, pressure);
    complete = complete && copyDisplacement(patches[k], known, pressure, displacement);
  }
  const double load = loadOf(patches, pressure);
  if (!(load > 0) || !std::isfinite(load))
  {
    return Start::none;
  }
  if (isLoadControlled(problem))
  {
    scaleToLoad(problem, patches, pressure, complete ? &displacement : nullptr);
  }
  return complete ? Start::complete : Start::pressure;
}

Start coldStart(const NormalProblem& problem, const std::vector<PatchLayout>& patches, const LaneBuffer& gap,
                LaneBuffer& pressure)
{
  const double first = firstTouch(patches);
  const double level = isLoadControlled(problem) ? levelForLoad(problem, patches, gap) : 0.5 * (first + problem.value);
  if (!(level > first))
  {
    return Start::none;
  }
  for (const PatchLayout& patch : patches)
  {
    // Hertz: p = 4 E* / (pi a) sqrt(depth of the deepest point) sqrt(depth), with depths below half the approach.
    const double own_level = patch.weight * level;
    const double depth = std::max(own_level - patch.least_gap, 0.0);
    const double radius = equivalentRadius(patch, gap, own_level);
    double* p = pressure.data() + patch.begin;
    laneKernels().root_depth(patch.size, own_level, gap.data() + patch.begin, p);
    const double factor = radius > 0 ? 4 * problem.modulus / (pi * radius) * std::sqrt(depth) / patch.stiffness : 0;
    laneKernels().scale(patch.size, factor, p);
  }
  if (isLoadControlled(problem))
  {
    scaleToLoad(problem, patches, pressure, nullptr);
  }
  return Start::pressure;
}
}  // namespace wheel_rail_contact::core
