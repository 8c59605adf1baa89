// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>

#include "../core/normal/errors_of.h"
#include "../core/normal/problems.h"
#include "core/balance/grid_levels.h"
#include "core/normal/estimate/unseen_slope.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/hertz_solver.h"
#include "core/normal/solvers/kik_piotrowski.h"
#include "core/normal/solvers/seidel.h"
#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
using problems::hertzCase;
using problems::HertzCase;

std::string digits(double value)
{
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
}

NormalSolution solved(NormalSolver& solver, const NormalProblem& problem)
{
  NormalSolution solution;
  solver.solve(problem, false, solution);
  return solution;
}

NormalSolution solvedClosely(const NormalProblem& problem)
{
  ConjugateGradientsOptions options;
  options.residual = 1e-8;
  ConjugateGradients solver(options);
  return solved(solver, problem);
}

Seidel seidelAsPrinted()
{
  SeidelOptions options;
  options.form = SeidelOptions::Form::printed;
  return Seidel(options);
}

std::string verdict(const NormalSolution& found, double expected)
{
  return isUsable(found.status) ? verdictOf(found.patches[0].max_pressure / expected - 1)
                                : std::string("refused: ") + toString(found.status);
}

/// A round contact of Hertz in cells `aspect` times as long as wide.
HertzCase inLongCells(double aspect)
{
  HertzCase hertz = hertzCase(1, 2, 2, false);
  const double width = 2.2 * hertz.exact.semi_axis_y, dy = width / 48;
  const int nx = 2 * static_cast<int>(std::ceil(0.5 * width / (aspect * dy)));
  const GapCurvature c = hertz.gap;
  hertz.problem = problems::underLoad(problems::sampled(problems::centredGrid(nx, 48, nx * aspect * dy, width, false),
                                                        [c](double x, double y) { return c.a * x * x + c.b * y * y; }),
                                      1e5);
  return hertz;
}

/// Projected iteration p = max(p - step (A p + gap - approach) / a_own, 0) at a given approach, each cell with the
/// others' old values (simultaneous) or with what they have become.
struct Iteration
{
  bool simultaneous;
  double step;
  double change;  ///< root mean square change over root mean square at which it stops
  int most_sweeps;
};

enum class End
{
  stopped,
  diverged,
  sweeps_spent
};

End iterate(const Iteration& how, const Eigen::MatrixXd& matrix, const Eigen::VectorXd& depth, Eigen::VectorXd& p)
{
  p.setZero(depth.size());
  const double rigid = depth.maxCoeff() / matrix.diagonal().minCoeff();
  for (int sweep = 0; sweep < how.most_sweeps; ++sweep)
  {
    const Eigen::VectorXd before = p;
    for (Eigen::Index i = 0; i < p.size(); ++i)
    {
      const double w = matrix.row(i).dot(how.simultaneous ? before : p) - depth[i];
      p[i] = std::max(p[i] - how.step * w / matrix(i, i), 0.0);
    }
    if (!(p.maxCoeff() < 100 * rigid))
    {
      return End::diverged;
    }
    if ((p - before).norm() <= how.change * p.norm())
    {
      return End::stopped;
    }
  }
  return End::sweeps_spent;
}

std::string runIteration(const Iteration& how, int cells)
{
  const HertzCase hertz = hertzCase(1, cells, cells, true);
  const NormalSolution truth = solvedClosely(hertz.problem);
  const PatchGap& patch = hertz.problem.patches[0];
  const Eigen::MatrixXd matrix = problems::influenceMatrix(patch.grid, hertz.problem.modulus);
  const Eigen::VectorXd depth = (truth.approach - patch.gap).reshaped().matrix();
  Eigen::VectorXd p;
  switch (iterate(how, matrix, depth, p))
  {
    case End::diverged:
      return "diverged";
    case End::sweeps_spent:
      return "swings on: no end in " + std::to_string(how.most_sweeps) + " sweeps";
    default:
      break;
  }
  const double off = (p - truth.patches[0].pressure.reshaped().matrix()).cwiseAbs().maxCoeff() / p.maxCoeff();
  return verdictOf(off) == "right" ? "right" : "says converged, a cell is " + verdictOf(off);
}
}  // namespace

MapTable aspectMap()
{
  MapTable table{"Long cells",
                 "A round contact (Hertz) in 48 cells across and ever longer cells. Point forces make the matrix "
                 "indefinite beyond 4.70.",
                 {"seidel_printed", "seidel", "conjugate_gradient"},
                 {}};
  for (const double aspect : {1.0, 2.0, 4.0, 4.6, 5.2, 7.0, 10.0})
  {
    const HertzCase hertz = inLongCells(aspect);
    const double expected = solvedClosely(hertz.problem).patches[0].max_pressure;
    ConjugateGradients gradients;
    Seidel printed = seidelAsPrinted(), repaired;
    table.rows.push_back(
        {"cells " + digits(aspect) + " times as long as wide",
         {verdict(solved(printed, hertz.problem), expected), verdict(solved(repaired, hertz.problem), expected),
          verdict(solved(gradients, hertz.problem), expected)}});
  }
  return table;
}

MapTable iterationMap()
{
  MapTable table{
      "Ways to iterate",
      "The same contact at a given approach with exact coefficients, iterated in ways that the package does not "
      "use: p = max(p − step · w / a_own, 0). Compared cell by cell with the solution on the same grid.",
      {"verdict"},
      {}};
  constexpr double change = 1e-6;
  for (const double step : {0.05, 0.1, 0.2, 1.0})
  {
    table.rows.push_back({"all cells at once, step " + digits(step) + ", 16 × 16 cells",
                          {runIteration({true, step, change, 4000}, 16)}});
  }
  for (const double step : {1.0, 1.5, 1.9, 1.95, 2.05})
  {
    table.rows.push_back({"cell after cell, over-relaxed by " + digits(step) + ", 16 × 16 cells",
                          {runIteration({false, step, change, 4000}, 16)}});
  }
  for (const int cells : {8, 16, 32, 48})
  {
    const std::string size = std::to_string(cells) + " × " + std::to_string(cells) + " cells";
    table.rows.push_back(
        {"cell after cell, stopped at a change of 1 %, " + size, {runIteration({false, 1, 1e-2, 4000}, cells)}});
  }
  return table;
}

namespace
{
/// Drop of a circle of radius r at distance y from its lowest place, |y| < r [m].
double drop(double r, double y)
{
  return r - std::sqrt(r * r - y * y);
}

/// Walls on both sides of a floor that ends at `half_width` [m] from its middle.
double walls(double half_width, double y)
{
  constexpr double steepness = 20;  // [1/m]
  const double beyond = std::max(std::abs(y) - half_width, 0.0);
  return steepness * beyond * beyond;
}

struct Shape
{
  std::string name;
  std::function<double(double)> across;  ///< gap at x = 0 [m]
};

std::vector<Shape> shapes()
{
  const auto corner = [](double wheel)
  { return [wheel](double y) { return drop(0.013, y) - drop(wheel, y) + walls(7e-3, y); }; };
  const auto lobes = [](double depth)
  {
    return [depth](double y)
    {
      const double q = y / 4e-3;
      return depth * (q * q - 1) * (q * q - 1);
    };
  };
  const auto wave = [](double y) { return 2 * y * y + 2e-6 * std::cos(2 * std::acos(-1.0) * y / 0.6e-3); };
  return {{"corner of 13 mm in 14 mm", corner(0.0140)},
          {"corner of 13 mm in 13.2 mm", corner(0.0132)},
          {"corner of 13 mm in 13.02 mm", corner(0.01302)},
          {"corner of 13 mm in 13 mm", corner(0.0130)},
          {"two lobes, merged", lobes(1e-5)},
          {"two lobes, nearly parted", lobes(5e-5)},
          {"two lobes, parted", lobes(2e-4)},
          {"flat across 10 mm", [](double y) { return walls(5e-3, y); }},
          {"saddle across 10 mm", [](double y) { return walls(5e-3, y) - 0.3 * y * y; }},
          {"curvature jumps from 1/300 to 1/80 mm",
           [](double y) { return (y < 1e-3 ? 1.7 : 1.7 + 4.6) * (y - 1e-3) * (y - 1e-3); }},
          {"step of 0.118 um (S1002, 35 mm) beside the crest",
           [](double y) { return 2 * y * y + (y > 0.5e-3 ? 0.118e-6 : 0); }},
          {"waves of 0.6 mm, 2 um high", wave}};
}

NormalProblem shaped(const Shape& shape, int nx, int ny)
{
  constexpr double length = 0.024, width = 0.018, wheel_radius = 0.46, load = 5e4;
  PatchGap patch = problems::sampled(problems::centredGrid(nx, ny, length, width, true),
                                     [&](double x, double y) { return x * x / (2 * wheel_radius) + shape.across(y); });
  constexpr double near = 1e-8;  // [m]
  fillUnseenSlope(patch,
                  [&](Eigen::Index j)
                  {
                    const double y = patch.grid.y(static_cast<int>(j));
                    return (shape.across(y + near) - shape.across(y - near)) / (2 * near);
                  });
  return problems::underLoad(std::move(patch), load);
}

/// The same where the contact may go beyond the box, in which the balance would lay another one.
std::string verdictInBox(const NormalSolution& found, double expected)
{
  const bool cut = isUsable(found.status) && found.patches[0].touches_border;
  return verdict(found, expected) + (cut ? ", cut off by the box" : "");
}

/// On the grids of `auto`, from coarse to fine until the estimate meets the tolerance.
std::string verdictOfGrids(const GridLevels& levels, const Shape& shape, double expected)
{
  constexpr double tolerance = 0.01;
  NormalSolution found;
  double estimate = 1;
  for (std::size_t level = 0; level < levels.count() && estimate > tolerance; ++level)
  {
    const NormalProblem problem = shaped(shape, levels.at(level).size.along, levels.at(level).size.across);
    found = solved(levels.solver(), problem);
    estimate = isUsable(found.status) ? errorsOf(levels.solver(), problem, found)[0].largest() : 1;
  }
  return verdictSaid(verdictInBox(found, expected), estimate > tolerance);
}

MapTable solveShapes()
{
  MapTable table{
      "Shapes across",
      "50 kN on a wheel of 0.46 m over these gaps, in a box of 24 × 18 mm: the grids of `auto` in turn until the "
      "estimate is below 1 %, and each method on 24 × 48 cells. The reference has four times as many each way. Corners "
      "end 7 mm from their middle, where walls rise. At a step the pressure has no highest value: the finer the cells, "
      "the higher. Pressure at the border of the box is noticed; the balance would lay another one.",
      {"grids of auto", "conjugate_gradient", "seidel", "seidel_printed", "kik_piotrowski", "hertz"},
      {}};
  const GridLevels levels{ContactModelConfig()};
  for (const Shape& shape : shapes())
  {
    ConjugateGradients gradients;
    Seidel repaired, printed = seidelAsPrinted();
    KikPiotrowski strips;
    HertzSolver hertz;
    const double expected = solved(gradients, shaped(shape, 96, 192)).patches[0].max_pressure;
    MapRow row{shape.name, {verdictOfGrids(levels, shape, expected)}};
    for (NormalSolver* solver : std::initializer_list<NormalSolver*>{&gradients, &repaired, &printed, &strips, &hertz})
    {
      row.verdicts.push_back(verdictInBox(solved(*solver, shaped(shape, 24, 48)), expected));
    }
    table.rows.push_back(row);
  }
  return table;
}
}  // namespace

const MapTable& shapeMap()
{
  static const MapTable table = solveShapes();
  return table;
}

MapTable fewCellsMap()
{
  MapTable table{
      "Patches of few cells",
      "An elliptic contact (Hertz, 1:2 in curvature) on 5 to 7 cells each way, few of which carry pressure (by "
      "`conjugate_gradient`). Is the error of its highest pressure within its estimate? It need not be, but the "
      "estimate is above 10 %: these answers are told to miss any tolerance below. From fewer than three cells the "
      "balance takes no answer: it lays another grid, and in the end refuses by that name.",
      {"conjugate_gradient", "its error estimate", "seidel", "seidel_printed"},
      {}};
  struct Coarse
  {
    int along, across;
    double margin;
    double shift = 0;  ///< of the grid, in cells
  };
  for (const auto& [along, across, margin, shift] : {Coarse{7, 7, 7.0},
                                                     {7, 6, 5.0},
                                                     {5, 7, 3.5},
                                                     {6, 6, 3.5},
                                                     {7, 7, 3.8},
                                                     {7, 6, 2.8},
                                                     {5, 5, 2.1, 0.25},
                                                     {7, 6, 2.1}})
  {
    const HertzCase hertz = hertzCase(2, along, across, false, margin, shift);
    const double exact = hertz.exact.max_pressure;
    ConjugateGradients gradients;
    Seidel repaired, printed = seidelAsPrinted();
    const NormalSolution found = solved(gradients, hertz.problem);
    const double estimate = errorsOf(gradients, hertz.problem, found)[0].largest();
    const bool holds = std::abs(found.patches[0].max_pressure / exact - 1) <= estimate;
    table.rows.push_back(
        {"cells with pressure: " + std::to_string((found.patches[0].pressure > 0).count()),
         {verdict(found, exact), std::string(holds ? "holds" : "too small") + (estimate > 0.1 ? ", above 10 %" : ""),
          verdict(solved(repaired, hertz.problem), exact), verdict(solved(printed, hertz.problem), exact)}});
  }
  return table;
}

MapTable boxMap()
{
  MapTable table{
      "Boxes",
      "`conjugate_gradient` on 16 × 32 cells in a box of another size than the contact. The balance widens a box "
      "that has pressure at its border, and lays a loose one anew.",
      {"verdict", "pressure at the border"},
      {}};
  for (const double margin : {0.8, 0.9, 1.0, 1.1, 2.0, 4.0, 8.0})
  {
    const HertzCase hertz = hertzCase(2, 16, 32, true, margin);
    ConjugateGradients solver;
    const NormalSolution solution = solved(solver, hertz.problem);
    table.rows.push_back(
        {"box " + digits(margin) + " times the contact",
         {verdict(solution, hertz.exact.max_pressure), solution.patches[0].touches_border ? "noticed" : "none"}});
  }
  return table;
}
}  // namespace wheel_rail_contact::core::stability
