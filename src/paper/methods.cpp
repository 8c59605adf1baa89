// SPDX-License-Identifier: BSD-3-Clause
#include "paper/methods.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/balance/rail_support.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/seidel.h"
#include "paper/one_wheel.h"

namespace wheel_rail_contact::core::paper
{
namespace
{
constexpr GridSize accurate_grid{64, 128};
constexpr double accurate_residual = 1e-5;
constexpr double late_stop = 1e-4;

MethodRow row(const ContactModelConfig& config, const RailDeflection& deflection, NormalSolver& solver,
              const GridSize& size, double stop)
{
  OneWheel wheel(config, solver, size);
  wheel.setRail(restingRail(config, Side::left).deflected(deflection));
  MethodRow row{solver.name(), size, 0, 0, stop, 0, {0, 0}, 0};
  if (wheel.solve(case_position, 0, printed_wheel_load))
  {
    const Grid& grid = wheel.contact().problem().patches.front().grid;
    row.cell_along = grid.dx;
    row.cell_across = grid.dy;
    row.iterations = wheel.contact().solution().iterations;
    row.figures = wheel.figures();
    row.counted_area = wheel.countedArea();
  }
  return row;
}

/// A grid of nearly square cells, with the number of columns given. How far a grid reaches beyond the contact depends
/// on its number of cells, so all numbers of rows are tried.
GridSize squares(const ContactModelConfig& config, const RailDeflection& deflection, int across)
{
  ConjugateGradients solver;
  GridSize best;
  double least = std::numeric_limits<double>::infinity();
  for (int along = across / 4 * 2; along <= 2 * across; along += 2)
  {
    const MethodRow laid = row(config, deflection, solver, {along, across}, 0);
    const double off = std::abs(std::log(laid.cell_along / laid.cell_across));
    if (off < least)
    {
      least = off;
      best = laid.size;
    }
  }
  return best;
}

MethodRow printedRow(const ContactModelConfig& config, const RailDeflection& deflection, const GridSize& size,
                     double change)
{
  SeidelOptions options;
  options.form = SeidelOptions::Form::printed;
  options.change = change;
  options.load_error = std::max(options.load_error, change);
  Seidel solver(options);
  return row(config, deflection, solver, size, change);
}
}  // namespace

std::vector<MethodRow> compareMethods(const ContactModelConfig& config, const RailDeflection& deflection)
{
  ConjugateGradientsOptions fine;
  fine.residual = accurate_residual;
  ConjugateGradients conjugate_gradients(fine);
  std::vector<MethodRow> rows{row(config, deflection, conjugate_gradients, accurate_grid, accurate_residual)};
  if (rows.front().figures.area == 0)
  {
    throw std::runtime_error("the accurate solution of the paper's case failed");
  }
  SeidelOptions repaired;
  repaired.residual = late_stop;
  Seidel seidel(repaired);
  rows.push_back(row(config, deflection, seidel, squares(config, deflection, 24), late_stop));
  for (const int across : {8, 12, 16, 24, 32})
  {
    rows.push_back(printedRow(config, deflection, squares(config, deflection, across), late_stop));
  }
  for (const double change : {1e-1, 3e-2, 1e-2, 1e-3})
  {
    rows.push_back(printedRow(config, deflection, squares(config, deflection, 24), change));
  }
  return rows;
}
}  // namespace wheel_rail_contact::core::paper
