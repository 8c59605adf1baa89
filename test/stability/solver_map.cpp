// SPDX-License-Identifier: BSD-3-Clause
#include "../core/normal/problems.h"
#include "core/balance/grid_levels.h"
#include "core/normal/estimate/error_estimate.h"
#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
using namespace problems;

Verdict verdict(const NormalSolution& found, double expected)
{
  return isUsable(found.status) ? Verdict::ofError(std::abs(found.patches[0].max_pressure / expected - 1))
                                : Verdict::refused(toString(found.status));
}

/// A round contact (Hertz) on cells that are `aspect` times as long as wide.
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

/// Projected iteration p = max(p - step (A p + gap - approach) / a_own, 0) at a given approach. Each cell uses the old
/// pressures of the other cells (simultaneous), or their new ones where available (successive).
struct Iteration
{
  bool simultaneous;
  double step;
  double change;  ///< root mean square change over root mean square at which the iteration stops [-]
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

/// The values of all cells, column after column.
Eigen::VectorXd asVector(const Eigen::ArrayXXd& cells)
{
  return Eigen::Map<const Eigen::VectorXd>(cells.data(), cells.size());
}

Verdict runIteration(const Iteration& how, int cells)
{
  const HertzCase hertz = hertzCase(1, cells, cells, true);
  const NormalSolution truth = solved(hertz.problem, 1e-8);
  const PatchGap& patch = hertz.problem.patches[0];
  const Eigen::MatrixXd matrix = problems::influenceMatrix(patch.grid, hertz.problem.modulus);
  const Eigen::VectorXd depth = asVector(truth.approach - patch.gap);
  Eigen::VectorXd p;
  switch (iterate(how, matrix, depth, p))
  {
    case End::diverged:
      return "diverges";
    case End::sweeps_spent:
      return "no convergence";
    default:
      break;
  }
  const double off = (p - asVector(truth.patches[0].pressure)).cwiseAbs().maxCoeff() / p.maxCoeff();
  return Verdict::ofError(off);
}
}  // namespace

MapTable aspectMap()
{
  MapTable table{"Long cells",
                 "A round contact (Hertz) on 48 cells across the track, with cells of increasing length. The reference "
                 "is the solution of the same grid with a residual of 1e-8. With the point forces of `seidel_printed` "
                 "the matrix is indefinite if the cells are more than 4.70 times as long as wide.",
                 {"seidel_printed", "seidel", "conjugate_gradient"},
                 {}};
  for (const double aspect : {1.0, 2.0, 4.0, 4.6, 5.2, 7.0, 10.0})
  {
    const HertzCase hertz = inLongCells(aspect);
    const double expected = solved(hertz.problem, 1e-8).patches[0].max_pressure;
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
      "Other iterations",
      "The same contact at a given approach with exact coefficients, solved by iterations that the package does not "
      "use: p = max(p − factor · w / a_own, 0). \"Simultaneous\" iterations use the old pressures of all other cells, "
      "\"successive\" ones the new pressures where available. They stop at a relative change of the pressure of 1e-6 "
      "unless another change is given, or after 4000 sweeps (\"no convergence\"). Some stop before they are accurate. "
      "The error is the largest one of a cell, relative to the highest pressure of the solution on the same grid.",
      {"result"},
      {}};
  constexpr double change = 1e-6;
  for (const double step : {0.05, 0.1, 0.2, 1.0})
  {
    table.rows.push_back(
        {"simultaneous, factor " + digits(step) + ", 16 × 16 cells", {runIteration({true, step, change, 4000}, 16)}});
  }
  for (const double step : {1.0, 1.5, 1.9, 1.95, 2.05})
  {
    table.rows.push_back(
        {"successive, factor " + digits(step) + ", 16 × 16 cells", {runIteration({false, step, change, 4000}, 16)}});
  }
  for (const int cells : {8, 16, 32, 48})
  {
    const std::string size = std::to_string(cells) + " × " + std::to_string(cells) + " cells";
    table.rows.push_back(
        {"successive, factor 1, change of 1 %, " + size, {runIteration({false, 1, 1e-2, 4000}, cells)}});
  }
  return table;
}

namespace
{
/// Height of a circle of radius r above its lowest point, at distance y from it, |y| < r [m].
double circleHeight(double r, double y)
{
  return r - std::sqrt(r * r - y * y);
}

/// Parabolas on both sides of a flat part of half width `half_width` [m].
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
  { return [wheel](double y) { return circleHeight(0.013, y) - circleHeight(wheel, y) + walls(7e-3, y); }; };
  const auto lobes = [](double depth)
  {
    return [depth](double y)
    {
      const double q = y / 4e-3;
      return depth * (q * q - 1) * (q * q - 1);
    };
  };
  const auto wave = [](double y) { return 2 * y * y + 2e-6 * std::cos(2 * std::acos(-1.0) * y / 0.6e-3); };
  return {
      {"radius 13 mm in 14 mm", corner(0.0140)},
      {"radius 13 mm in 13.2 mm", corner(0.0132)},
      {"radius 13 mm in 13.02 mm", corner(0.01302)},
      {"radius 13 mm in 13 mm", corner(0.0130)},
      {"two lobes, merged", lobes(1e-5)},
      {"two lobes, nearly separate", lobes(5e-5)},
      {"two lobes, separate", lobes(2e-4)},
      {"flat across 10 mm", [](double y) { return walls(5e-3, y); }},
      {"saddle across 10 mm", [](double y) { return walls(5e-3, y) - 0.3 * y * y; }},
      {"curvature discontinuity, radius 300 to 80 mm",
       [](double y) { return (y < 1e-3 ? 1.7 : 1.7 + 4.6) * (y - 1e-3) * (y - 1e-3); }},
      {"step of 0.118 µm next to the pressure peak", [](double y) { return 2 * y * y + (y > 0.5e-3 ? 0.118e-6 : 0); }},
      {"waves of 0.6 mm length and 2 µm amplitude", wave}};
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

/// Verdict with a remark if there is pressure at the border of the grid.
Verdict verdictInBox(const NormalSolution& found, double expected)
{
  const bool cut = isUsable(found.status) && found.patches[0].touches_border;
  return verdict(found, expected).with(cut ? "at the border" : "");
}

/// Verdict on the grids of `auto`: the first one, and finer ones while the error estimate exceeds the tolerance.
Verdict verdictOfGrids(const GridLevels& levels, const Shape& shape, double expected)
{
  constexpr double tolerance = 0.01;
  NormalSolution found;
  double estimate = 1;
  std::size_t level = 0, next = 0;
  do
  {
    level = next;
    const NormalProblem problem = shaped(shape, levels.at(level).along, levels.at(level).across);
    found = solved(levels.solver(), problem);
    estimate = isUsable(found.status) ? errorsOf(levels.solver(), problem, found)[0].largest() : 1;
    next = levels.finer(level, estimate);
  } while (next != level);
  return verdictInBox(found, expected).withFlag(estimate, tolerance);
}
}  // namespace

MapTable shapeMap()
{
  MapTable table{
      "Gaps that differ from Hertz",
      "50 kN on a wheel of radius 0.46 m, with these gaps across the track, on a grid of 24 × 18 mm. Column `auto`: "
      "the first grid of `auto`, and finer ones while the error estimate is above 0.01. Other methods: 24 × 48 "
      "cells, without an error estimate. The reference is `conjugate_gradient` on 96 × 192 cells. \"At the border\": "
      "there is pressure in the outer cells; a wheelset is then solved again on a larger grid. The conformal "
      "gaps (radius 13 mm in 14 mm to 13 mm) end in steep parabolas 7 mm from their middle, the flat one and the "
      "saddle 5 mm from it. The step is as high as that of S1002 at y = −35 mm. At a step the exact pressure is "
      "unbounded: the highest pressure grows as the cells become smaller.",
      methodNames(),
      {}};
  const GridLevels levels{ContactModelConfig()};
  for (const Shape& shape : shapes())
  {
    ConjugateGradients gradients;
    const double expected = solved(gradients, shaped(shape, 96, 192)).patches[0].max_pressure;
    MapRow row{shape.name, {}};
    for (const NormalMethod method : all_normal_methods)
    {
      row.verdicts.push_back(method == NormalMethod::automatic
                                 ? verdictOfGrids(levels, shape, expected)
                                 : verdictInBox(solved(*makeNormalSolver(method), shaped(shape, 24, 48)), expected));
    }
    table.rows.push_back(row);
  }
  return table;
}

MapTable fewCellsMap()
{
  MapTable table{
      "Patches of few cells",
      "An elliptic contact (Hertz, curvatures 1:2) on 5 to 7 cells each way, few of which have pressure (counted for "
      "`conjugate_gradient`). The reference is the exact solution. Column \"error estimate\": whether the estimate of "
      "`conjugate_gradient` covers the error of the highest pressure, and whether it is above 10 %. A result "
      "with such an estimate is flagged at any tolerance up to 10 %.",
      {"conjugate_gradient", "error estimate", "seidel", "seidel_printed"},
      {}};
  struct Coarse
  {
    int along, across;
    double margin;
    double shift = 0;  ///< of the grid, in cells
  };
  constexpr Coarse grids[] = {{7, 7, 7.0}, {7, 6, 5.0}, {5, 7, 3.5},       {6, 6, 3.5},
                              {7, 7, 3.8}, {7, 6, 2.8}, {5, 5, 2.1, 0.25}, {7, 6, 2.1}};
  for (const auto& [along, across, margin, shift] : grids)
  {
    const HertzCase hertz = hertzCase(2, along, across, false, margin, shift);
    const double exact = hertz.exact.max_pressure;
    ConjugateGradients gradients;
    Seidel repaired, printed = seidelAsPrinted();
    const NormalSolution found = solved(gradients, hertz.problem);
    const double estimate = errorsOf(gradients, hertz.problem, found)[0].largest();
    const double error = std::abs(found.patches[0].max_pressure / exact - 1);
    table.rows.push_back(
        {"cells with pressure: " + std::to_string((found.patches[0].pressure > 0).count()),
         {verdict(found, exact),
          Verdict::byLimit(error, estimate, "too small", "covers the error")
              .with(Verdict::byLimit(estimate, 0.1, "above 10 %", "")),
          verdict(solved(repaired, hertz.problem), exact), verdict(solved(printed, hertz.problem), exact)}});
  }
  return table;
}

MapTable boxMap()
{
  MapTable table{
      "Size of the grid",
      "An elliptic contact (Hertz, curvatures 1:2), solved by `conjugate_gradient` on 16 × 32 cells. The grid is "
      "smaller or larger than the contact. The reference is the exact solution. The grid of a wheelset covers the "
      "overlap "
      "of the undeformed bodies, which is about 1.4 times as large as the contact.",
      {"conjugate_gradient", "pressure at the border"},
      {}};
  for (const double margin : {0.8, 0.9, 1.0, 1.1, 2.0, 4.0, 8.0})
  {
    const HertzCase hertz = hertzCase(2, 16, 32, true, margin);
    ConjugateGradients solver;
    const NormalSolution solution = solved(solver, hertz.problem);
    table.rows.push_back(
        {"grid " + digits(margin) + " times as large as the contact",
         {verdict(solution, hertz.exact.max_pressure), solution.patches[0].touches_border ? "yes" : "no"}});
  }
  return table;
}
}  // namespace wheel_rail_contact::core::stability
