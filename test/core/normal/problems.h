// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../usual_headers.h"
#include "core/normal/operator/influence.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/hertz.h"
#include "core/normal/solvers/seidel.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Contact under a force [N]. The force grows with the approach to the power 3/2.
inline HertzContact hertzForForce(const GapCurvature& gap, double modulus, double force)
{
  return hertzForApproach(gap, modulus, std::pow(force / hertzForApproach(gap, modulus, 1).force, 2.0 / 3));
}

/// Estimated errors of each patch of a solution.
inline std::vector<ErrorEstimate> errorsOf(const NormalSolver& solver, const NormalProblem& problem,
                                           const NormalSolution& solution)
{
  std::vector<ErrorEstimate> errors;
  solver.estimateErrors(problem, solution, errors);
  return errors;
}
}  // namespace wheel_rail_contact::core

/// Normal contact problems for tests.
namespace wheel_rail_contact::core::problems
{
/// Contact modulus of steel on steel [Pa].
inline double steel()
{
  return contactModulus(Material(), Material());
}

inline Grid centredGrid(int nx, int ny, double length, double width, bool symmetric)
{
  Grid grid;
  grid.nx = nx;
  grid.ny = ny;
  grid.dx = length / nx;
  grid.dy = width / ny;
  grid.y0 = 0.5 * (grid.dy - width);
  grid.symmetric = symmetric;
  return grid;
}

/// Patch whose gap is f(x, y).
template <typename Gap>
PatchGap sampled(const Grid& grid, const Gap& f)
{
  PatchGap patch;
  patch.grid = grid;
  patch.gap.resize(grid.rows(), grid.ny);
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.rows(); ++i)
    {
      patch.gap(i, j) = f(grid.x(i), grid.y(j));
    }
  }
  return patch;
}

inline NormalProblem underLoad(PatchGap patch, double load)
{
  NormalProblem problem;
  problem.patches.push_back(std::move(patch));
  problem.modulus = steel();
  problem.value = load;
  return problem;
}

/// The same problem at a given approach [m].
template <typename Problem>
Problem atApproach(Problem problem, double approach)
{
  problem.control = NormalProblem::Control::approach;
  problem.value = approach;
  return problem;
}

/// Largest difference of the pressures of a patch, relative to the highest one of the second solution [-].
inline double difference(const NormalSolution& one, const NormalSolution& other, std::size_t patch = 0)
{
  return (one.patches[patch].pressure - other.patches[patch].pressure).abs().maxCoeff() /
         other.patches[patch].pressure.maxCoeff();
}

/// Conjugate gradients that stop at a residual [-].
inline ConjugateGradients solverTo(double residual, int max_products = ConjugateGradientsOptions().max_products)
{
  ConjugateGradientsOptions options;
  options.residual = residual;
  options.max_products = max_products;
  return ConjugateGradients(options);
}

/// Seidel's iteration as printed in the paper.
inline Seidel seidelAsPrinted()
{
  SeidelOptions options;
  options.form = SeidelOptions::Form::printed;
  return Seidel(options);
}

/// Solution without a start.
inline NormalSolution solved(NormalSolver& solver, const NormalProblem& problem)
{
  NormalSolution solution;
  solver.solve(problem, false, solution);
  return solution;
}

/// Solution by conjugate gradients, without a start.
inline NormalSolution solved(const NormalProblem& problem, double residual = ConjugateGradientsOptions().residual,
                             int max_products = ConjugateGradientsOptions().max_products)
{
  ConjugateGradients solver = solverTo(residual, max_products);
  return solved(solver, problem);
}

/// Ellipsoid on a plane in a box `margin` times as long and wide as the contact. B/A = `ratio`; A is that of a wheel.
struct HertzCase
{
  GapCurvature gap;
  HertzContact exact;
  NormalProblem problem;
};

inline HertzCase hertzCase(double ratio, int nx, int ny, bool symmetric, double margin = 1.1, double shift = 0)
{
  constexpr double load = 1e5, wheel_radius = 0.46;
  HertzCase hertz;
  hertz.gap = {0.5 / wheel_radius, 0.5 / wheel_radius * ratio};
  hertz.exact = hertzForForce(hertz.gap, steel(), load);
  Grid grid =
      centredGrid(nx, ny, 2 * margin * hertz.exact.semi_axis_x, 2 * margin * hertz.exact.semi_axis_y, symmetric);
  grid.y0 += shift * grid.dy;
  const GapCurvature c = hertz.gap;
  hertz.problem = underLoad(sampled(grid, [c](double x, double y) { return c.a * x * x + c.b * y * y; }), load);
  return hertz;
}

/// Solution without a start, which must converge.
inline NormalSolution converged(NormalSolver& solver, const NormalProblem& problem)
{
  NormalSolution solution = solved(solver, problem);
  return solution.status == SolveStatus::converged ? solution : throw std::runtime_error(toString(solution.status));
}

/// The same problem on a curved surface, with normals to be set.
inline CurvedProblem curved(const NormalProblem& plane)
{
  CurvedProblem problem;
  static_cast<NormalProblem&>(problem) = plane;
  problem.normals.resize(plane.patches.size());
  return problem;
}

/// Solution by conjugate gradients to a residual of 1e-9.
inline NormalSolution solvedCurved(const CurvedProblem& problem, NormalSolution solution = {}, bool warm = false)
{
  solverTo(1e-9).solveCurved(problem, warm, solution);
  return solution;
}

/// Matrix of the influence coefficients of a grid [m/Pa], with the cells in the order of the gap array.
inline Eigen::MatrixXd influenceMatrix(const Grid& grid, double modulus, Kernel kernel = Kernel::rectangle)
{
  const double factor = 1 / (std::acos(-1.0) * modulus);
  const int rows = grid.rows(), cells = rows * grid.ny;
  Eigen::MatrixXd matrix(cells, cells);
  for (int a = 0; a < cells; ++a)
  {
    for (int b = 0; b < cells; ++b)
    {
      const double x = grid.x(a % rows), y = grid.y(a / rows) - grid.y(b / rows), source = grid.x(b % rows);
      double sum = influence(kernel, x - source, y, grid.dx, grid.dy);
      if (grid.symmetric)
      {
        sum += influence(kernel, x + source, y, grid.dx, grid.dy);
      }
      matrix(a, b) = factor * sum;
    }
  }
  return matrix;
}

/// The matrix of a patch whose columns are turned, for the loaded cells (1, others 0). Others have rows of the
/// identity.
inline Eigen::MatrixXd restricted(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& loaded)
{
  Eigen::MatrixXd part = matrix.cwiseProduct(loaded * loaded.transpose());
  part.diagonal() += Eigen::VectorXd::Ones(loaded.size()) - loaded;
  return part;
}

inline double uniform(std::mt19937_64& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Bowl with waves and noise of random size, on a grid of random shape with cell aspects of 1/5 to 6.
inline PatchGap randomPatch(std::mt19937_64& random)
{
  constexpr std::array<std::array<int, 2>, 6> sizes = {{{4, 16}, {8, 16}, {8, 32}, {12, 20}, {6, 10}, {16, 32}}};
  const auto& size = sizes[random() % sizes.size()];
  const double dy = uniform(random, 1e-4, 5e-4), dx = dy * std::exp(uniform(random, std::log(0.2), std::log(6.0)));
  const double length = size[0] * dx, width = size[1] * dy, depth = uniform(random, 3e-5, 1.3e-4);
  const double waves = uniform(random, 0, 0.5) * depth, noise = uniform(random, 0, 0.1) * depth;
  std::array<double, 3> height{}, phase{};
  for (std::size_t k = 0; k < height.size(); ++k)
  {
    height[k] = waves * uniform(random, -1, 1);
    phase[k] = uniform(random, 0, 6.28);
  }
  const auto gap = [&](double x, double y)
  {
    const double u = 2 * x / length, v = 2 * y / width;
    double value = 2 * depth * (u * u + v * v) + noise * uniform(random, -1, 1);
    for (std::size_t k = 0; k < height.size(); ++k)
    {
      value += height[k] * std::cos(3.0 * (static_cast<double>(k) + 1) * v + phase[k]);
    }
    return value;
  };
  return sampled(centredGrid(size[0], size[1], length, width, random() % 2 == 0), gap);
}

/// Random patches with different weights, under a load or at an approach that fills a small or large part of them.
inline NormalProblem randomProblem(std::mt19937_64& random, int patches)
{
  NormalProblem problem;
  problem.modulus = steel();
  double touch = 1, deep = 0, size = 0;
  for (int k = 0; k < patches; ++k)
  {
    PatchGap patch = randomPatch(random);
    patch.weight = patches == 1 ? 1 : uniform(random, 0.3, 1);
    touch = std::min(touch, patch.gap.minCoeff() / patch.weight);
    deep = std::max(deep, patch.gap.maxCoeff() / patch.weight);
    size = std::max(size, std::sqrt(static_cast<double>(patch.gap.size()) * patch.grid.cellArea()));
    problem.patches.push_back(std::move(patch));
  }
  const double part = std::pow(uniform(random, 0.03, 0.6), 1.5);
  if (random() % 3 == 0)
  {
    problem.control = NormalProblem::Control::approach;
    problem.value = touch + part * (deep - touch);
  }
  else
  {
    problem.value = 0.3 * problem.modulus * size * part * (deep - touch);
  }
  return problem;
}
}  // namespace wheel_rail_contact::core::problems
