// SPDX-License-Identifier: BSD-3-Clause
#include "../../seeded.h"
#include "core/constants.h"
#include "core/creep/tangential_influence.h"
#include "creep_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
TEST(TangentialInfluence, IsTheSumOfCerrutisPointForces)
{
  const double dx = 0.3, dy = 0.2, poisson = 0.28;
  for (const auto& [x, y] : {std::pair(0.5, 0.1), std::pair(-0.7, 0.4), std::pair(0.0, -0.9), std::pair(4.0, 3.0)})
  {
    // Midpoint rule with 200 × 200 points: its error is below 1e-5 outside of the rectangle.
    const int points = 200;
    TangentialInfluence sum;
    for (int i = 0; i < points; ++i)
    {
      for (int j = 0; j < points; ++j)
      {
        const double u = x - ((i + 0.5) / points - 0.5) * dx, v = y - ((j + 0.5) / points - 0.5) * dy;
        const double rho = std::hypot(u, v), area = dx * dy / points / points;
        sum.xx += area * (1 / rho - poisson * v * v / (rho * rho * rho));
        sum.yy += area * (1 / rho - poisson * u * u / (rho * rho * rho));
        sum.xy += area * poisson * u * v / (rho * rho * rho);
      }
    }
    const TangentialInfluence exact = tangentialInfluence(x, y, dx, dy, poisson);
    EXPECT_NEAR(exact.xx, sum.xx, 1e-5 * sum.xx);
    EXPECT_NEAR(exact.yy, sum.yy, 1e-5 * sum.yy);
    EXPECT_NEAR(exact.xy, sum.xy, 1e-5 * sum.xx);
  }
}

TEST(ExactRolling, SmallCreepageFollowsKalkersCoefficients)
{
  for (const double ratio : {0.3, 1.0, 2.5})
  {
    const double product = 4e-5, a = std::sqrt(product * ratio), b = product / a, cube = std::pow(product, 1.5);
    const KalkerCoefficients c = kalkerCoefficients(ratio, 0.25);
    const ShearElasticity elasticity = {8e10, 0.25};
    const double g = elasticity.modulus, small = 1e-7;  // of the creepage of sliding: 1e-4
    const auto force = [&](const Creepage& creep, int cells = 48) {
      return ellipseCreepForce({a, b, 1e5, cells, cells}, creep, CreepMethod::exact, {}, elasticity);
    };
    // The singular traction at the trailing edge costs 2 % on 48 × 48 cells, and more where the edges weigh more: up to
    // 5 % of C23, and 10 % of C33 (24 × 24: 20 %, 64 × 64: 7 %, 96 × 96: 5 %).
    EXPECT_NEAR(force({small, 0, 0}).x / (-g * product * c.c11 * small), 1, 0.02) << ratio;
    EXPECT_NEAR(force({0, small, 0}).y / (-g * product * c.c22 * small), 1, 0.02) << ratio;
    EXPECT_NEAR(force({0, small, 0}).moment / (g * cube * c.c23 * small), 1, 0.05) << ratio;
    EXPECT_NEAR(force({0, 0, 10 * small}).y / (-g * cube * c.c23 * 10 * small), 1, 0.05) << ratio;
    EXPECT_NEAR(force({0, 0, 10 * small}, 64).moment / (-g * product * product * c.c33 * 10 * small), 1, 0.08) << ratio;
  }
}

TEST(ExactRolling, NarrowContactIsCartersStrip)
{
  // Carter (1926), Johnson (1985) section 8.3: a strip with the peak pressure p0 slides at the creepage 2 mu p0 (1 -
  // nu) / G, and has the share 1 - (1 - r)² of the limit at r times this creepage. For a Hertzian ellipse, whose strips
  // have the peaks p0 sqrt(1 - y²/b²), this is integrated over y.
  const double a = 0.003, b = 0.06, normal_force = 1e5, friction = 0.3;
  const ShearElasticity elasticity = {8e10, 0.25};
  const double peak = 1.5 * normal_force / (pi * a * b);
  const double sliding = friction * 2 * peak * (1 - elasticity.poisson) / elasticity.modulus;
  for (const double r : {0.1, 0.3, 0.6, 0.9, 1.2})
  {
    const CreepEllipse ellipse = {a, b, normal_force, 64, 32};
    const CreepForce force =
        ellipseCreepForce(ellipse, {r * sliding, 0, 0}, CreepMethod::exact, {friction, 1, 0}, elasticity);
    const double end = std::sqrt(std::max(0.0, 1 - r * r));  // strips beyond it slide
    const double expected = 1.5 * (r * std::asin(end) + (1 - end) - (1 - end * end * end) / 3);
    // Ends of the ellipse and 60 cells: 0.5 %.
    EXPECT_NEAR(-force.x / (friction * normal_force), expected, 0.005) << r;
  }
}

struct DenseSlip
{
  Eigen::ArrayXXd x, y;
};
/// Slip of each cell over one cell, relative to the running speed [m], from sums over all cells. Rolling along +x.
DenseSlip denseSlip(const CreepProblem& problem, const CreepSolution& solution)
{
  const PatchGrid& g = problem.grid;
  DenseSlip slip = {Eigen::ArrayXXd(g.nx, g.ny), Eigen::ArrayXXd(g.nx, g.ny)};
  const double unit = 1 / (pi * problem.elasticity.modulus), nu = problem.elasticity.poisson;
  for (int i = 0; i < g.nx; ++i)
  {
    for (int j = 0; j < g.ny; ++j)
    {
      double x = g.dx * (problem.creepage.x - problem.creepage.spin * g.y(j));
      double y = g.dx * (problem.creepage.y + problem.creepage.spin * (g.x(i) + 0.25 * g.dx));
      for (int k = 0; k < g.nx; ++k)
      {
        for (int l = 0; l < g.ny; ++l)
        {
          const double u = (i - k) * g.dx, v = (j - l) * g.dy;
          const TangentialInfluence here = tangentialInfluence(u, v, g.dx, g.dy, nu);
          const TangentialInfluence ahead = tangentialInfluence(u + g.dx, v, g.dx, g.dy, nu);
          const double px = unit * solution.traction_x(k, l), py = unit * solution.traction_y(k, l);
          x += (here.xx - ahead.xx) * px + (here.xy - ahead.xy) * py;
          y += (here.xy - ahead.xy) * px + (here.yy - ahead.yy) * py;
        }
      }
      slip.x(i, j) = x;
      slip.y(i, j) = y;
    }
  }
  return slip;
}

TEST(ExactRolling, MeetsTheContactConditionsInEachCell)
{
  CreepProblem problem = ellipseProblem({0.006, 0.004, 1e5, 14, 12}, {6e-4, 9e-4, 0.3});
  problem.pressure.rightCols(4) *= 0.6;  // no ellipse
  const CreepSolution solution = CreepScene::solve(CreepMethod::exact, problem);
  ASSERT_EQ(solution.status, CreepStatus::converged);
  const DenseSlip slip = denseSlip(problem, solution);
  const double scale = CreepScene::friction_limit / (problem.pressure.sum() * problem.grid.cellArea());
  const double rigid = problem.grid.dx * 1e-3;
  int sticking = 0, sliding = 0;
  for (int i = 0; i < problem.grid.nx; ++i)
  {
    for (int j = 0; j < problem.grid.ny; ++j)
    {
      const double bound = scale * problem.pressure(i, j);
      const double px = solution.traction_x(i, j), py = solution.traction_y(i, j), length = std::hypot(px, py);
      EXPECT_LE(length, bound * (1 + 1e-9));
      if (bound > 0)
      {
        const bool sticks = length < 0.999 * bound;
        (sticks ? sticking : sliding) += 1;
        const double size = sticks ? 0 : std::hypot(slip.x(i, j), slip.y(i, j)) / length;
        // The sweeps end at changes of 5e-4; the slip is accurate to about 1 % of the rigid one.
        EXPECT_NEAR(slip.x(i, j), -size * px, 0.01 * rigid) << i << ' ' << j;
        EXPECT_NEAR(slip.y(i, j), -size * py, 0.01 * rigid) << i << ' ' << j;
      }
    }
  }
  EXPECT_GT(sticking, 10);
  EXPECT_GT(sliding, 10);
}

TEST(ExactRolling, WarmStartNeedsFewerSweepsForTheSameForce)
{
  const auto solver = makeCreepSolver(CreepMethod::exact);
  CreepSolution solution;
  CreepProblem problem = CreepScene().problem({5e-4, 5e-4, 0.2});
  solver->solve(problem, false, solution);
  problem.creepage.y *= 1.01;
  solver->solve(problem, true, solution);
  const CreepSolution cold = CreepScene::solve(CreepMethod::exact, problem);
  EXPECT_LT(solution.iterations, cold.iterations);
  EXPECT_NEAR(solution.force.y, cold.force.y, 2e-3 * CreepScene::friction_limit);
}

TEST(ExactRolling, PatchesOfAnyShapeConverge)
{
  // Random spots of pressure, up to four on a grid, with holes and single cells.
  Seeded random(4);
  const auto unit = [&random] { return random.within(0, 1); };
  const auto solver = makeCreepSolver(CreepMethod::exact);
  CreepSolution solution;
  for (int i = 0; i < 100; ++i)
  {
    const int nx = 4 + static_cast<int>(20 * unit()), ny = 4 + static_cast<int>(30 * unit());
    const double size = std::pow(10, 4 * unit() - 5);
    CreepProblem problem = ellipseProblem({0.002 + 0.01 * unit(), 0.002 + 0.01 * unit(), 1e5, nx, ny},
                                          {size * (unit() - 0.5), size * (unit() - 0.5), 300 * size * unit()});
    problem.pressure = 0;
    for (double spots = 4 * unit(); spots > 0; --spots)
    {
      const double u = nx * unit(), v = ny * unit(), r = 0.3 + 0.5 * nx * unit(), top = unit();
      for (int k = 0; k < nx * ny; ++k)
      {
        const double x = (k % nx - u) / r, y = (k / nx - v) / r;
        double& p = problem.pressure(k % nx, k / nx);
        p = std::max(p, 1e9 * top * (1 - x * x - y * y));
      }
    }
    solver->solve(problem, false, solution);
    const bool is_empty = !(problem.pressure.sum() > 0);
    EXPECT_EQ(solution.status, is_empty ? CreepStatus::invalid_problem : CreepStatus::converged) << "case " << i;
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
