// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/grid_levels.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/balance/tuning.h"
#include "core/normal/solvers/conjugate_gradients.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_residual = 1e-6;  ///< [-]

/// Number of cells up to which a grid is prepared for all cell shapes. On a larger grid, which can only be set by hand,
/// a shape is prepared at its first use: preparing all of them would take seconds.
constexpr int most_prepared_cells = 64 * 192;

/// 8 x 16 cells would save no time: up to every third wheel would be solved again on a finer grid (doc/methods.md).
constexpr std::array<GridSize, 7> sizes{{{12, 24}, {16, 32}, {16, 48}, {24, 64}, {32, 96}, {48, 128}, {64, 192}}};

/// First grid for an expected error of 1 / (cells along)². The true error is a quarter of it.
const GridSize* firstFor(double error)
{
  return std::find_if(sizes.begin(), sizes.end() - 1,
                      [&](const GridSize& size) { return 1 <= error * size.along * size.along; });
}

std::vector<GridSize> sizesFor(const ContactConfig& contact, double tolerance)
{
  if (contact.cells_along > 0)
  {
    return {{contact.cells_along, contact.cells_across}};
  }
  if (contact.method != NormalMethod::automatic)
  {
    return {*firstFor(0.5 * tolerance)};
  }
  const GridSize* const first = firstFor(tolerance);
  return {first, first + 1 + std::min<std::ptrdiff_t>(tuning::most_refinements, sizes.end() - 1 - first)};
}

std::unique_ptr<NormalSolver> makeSolver(const ContactModelConfig& config, const std::vector<GridSize>& grids)
{
  const NormalMethod method = config.contact.method;
  if (method != NormalMethod::automatic && method != NormalMethod::conjugate_gradient)
  {
    return makeNormalSolver(method);
  }
  ConjugateGradientsOptions options;
  options.residual = std::max(tuning::residual_per_tolerance * searchTolerance(config), least_residual);
  auto solver = std::make_unique<ConjugateGradients>(options);
  for (const GridSize& size : grids)
  {
    if (size.along * size.across <= most_prepared_cells)
    {
      solver->prepare(size.along, size.across);
    }
  }
  return solver;
}
}  // namespace

double searchTolerance(const ContactModelConfig& config)
{
  const double tolerance = config.contact.tolerance;
  return config.wheelset.solve_height_and_roll ? tolerance : std::min(tolerance, tuning::given_height_tolerance);
}

GridLevels::GridLevels(const ContactModelConfig& config, const Wrap& wrap)
    : tolerance_(config.contact.tolerance), sizes_(sizesFor(config.contact, searchTolerance(config)))
{
  solver_ = makeSolver(config, sizes_);
  if (wrap)
  {
    solver_ = wrap(std::move(solver_));
  }
}

std::size_t GridLevels::finer(std::size_t level, double error) const
{
  const auto cells = [this](std::size_t k) { return static_cast<double>(sizes_[k].along) * sizes_[k].across; };
  const auto fall = [&](std::size_t k) { return cells(level) / cells(k) * cells(level) / cells(k); };
  std::size_t next = level;
  while (next + 1 < count() && error * fall(next) > tolerance_)
  {
    ++next;
  }
  return next;
}
}  // namespace wheel_rail_contact::core
