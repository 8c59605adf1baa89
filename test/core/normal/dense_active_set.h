// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>

#include "problems.h"

/// Exact solution of small normal contact problems, as the reference of tests.
namespace wheel_rail_contact::core::problems
{
/// Active-set method with a Cholesky factorisation of the matrix of the loaded cells in each step. Cells with negative
/// pressure leave the contact and cells with negative distance enter it, until there are none of either. All of them
/// change at once as long as their number decreases, otherwise only the worst one (Júdice and Pires 1994). Patches are
/// coupled only by load and approach.
class DenseActiveSet
{
 public:
  /// Pressures of the patches [Pa] and the common approach [m].
  struct Result
  {
    std::vector<Eigen::ArrayXXd> pressure;
    double approach = 0;
    int factorisations = 0;
  };

  explicit DenseActiveSet(const NormalProblem& problem, std::vector<ColumnNormals> normals = {}) : problem_(problem)
  {
    normals.resize(problem.patches.size());
    for (std::size_t k = 0; k < normals.size(); ++k)
    {
      const PatchGap& patch = problem.patches[k];
      State state;
      state.matrix = influenceMatrix(patch.grid, problem.modulus);
      state.weight = patch.weight * ofCells(patch, normals[k].weight, 1);
      const Eigen::VectorXd turn = ofCells(patch, normals[k].turn, 0);
      for (Eigen::Index i = 0; i < turn.size(); ++i)
      {
        state.matrix.col(i).array() *= (turn.array() - turn[i]).cos();
      }
      state.gap = Eigen::Map<const Eigen::VectorXd>(patch.gap.data(), patch.gap.size());
      state.loaded.assign(static_cast<std::size_t>(patch.gap.size()), true);
      states_.push_back(std::move(state));
    }
  }

  Result solve()
  {
    Result result;
    int least = -1, patience = 10;
    while (true)
    {
      solveLoaded(result.approach);
      ++result.factorisations;
      const int wrong = countWrong();
      if (wrong == 0)
      {
        break;
      }
      patience = least < 0 || wrong < least ? 10 : patience - 1;
      least = least < 0 ? wrong : std::min(least, wrong);
      change(patience > 0);
      if (result.factorisations > 2000)
      {
        throw std::runtime_error("the active set does not converge");
      }
    }
    for (std::size_t k = 0; k < states_.size(); ++k)
    {
      const Grid& grid = problem_.patches[k].grid;
      result.pressure.emplace_back(Eigen::Map<Eigen::ArrayXXd>(states_[k].pressure.data(), grid.rows(), grid.ny));
    }
    return result;
  }

 private:
  struct State
  {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd weight, gap, pressure, distance, response, closing;
    std::vector<bool> loaded;
  };

  /// Values of the columns, or `constant` if there are none, as values of the cells.
  static Eigen::VectorXd ofCells(const PatchGap& patch, const Eigen::ArrayXd& columns, double constant)
  {
    Eigen::VectorXd cells = Eigen::VectorXd::Constant(patch.gap.size(), constant);
    for (Eigen::Index i = 0; i < cells.size() && columns.size() > 0; ++i)
    {
      cells[i] = columns[i / patch.grid.rows()];
    }
    return cells;
  }

  /// Computes the approach and the pressures of the loaded cells for which their distance is zero.
  void solveLoaded(double& approach)
  {
    double by_approach = 0, by_gap = 0;  // load = by_approach * approach - by_gap
    for (std::size_t k = 0; k < states_.size(); ++k)
    {
      State& s = states_[k];
      const PatchGap& patch = problem_.patches[k];
      s.response = solveOn(s, s.weight);
      s.closing = solveOn(s, s.gap);
      by_approach += patch.grid.cellArea() * s.weight.dot(s.response);
      by_gap += patch.grid.cellArea() * s.weight.dot(s.closing);
    }
    approach =
        problem_.control == NormalProblem::Control::load ? (problem_.value + by_gap) / by_approach : problem_.value;
    for (std::size_t k = 0; k < states_.size(); ++k)
    {
      State& s = states_[k];
      s.pressure = approach * s.response - s.closing;
      s.distance = s.matrix * s.pressure + s.gap - approach * s.weight;
    }
  }

  static Eigen::VectorXd solveOn(const State& s, const Eigen::VectorXd& right)
  {
    std::vector<Eigen::Index> cells;
    for (std::size_t i = 0; i < s.loaded.size(); ++i)
    {
      if (s.loaded[i])
      {
        cells.push_back(static_cast<Eigen::Index>(i));
      }
    }
    const auto n = static_cast<Eigen::Index>(cells.size());
    Eigen::MatrixXd matrix(n, n);
    Eigen::VectorXd part(n);
    for (Eigen::Index a = 0; a < n; ++a)
    {
      part(a) = right(cells[static_cast<std::size_t>(a)]);
      for (Eigen::Index b = 0; b < n; ++b)
      {
        matrix(a, b) = s.matrix(cells[static_cast<std::size_t>(a)], cells[static_cast<std::size_t>(b)]);
      }
    }
    const Eigen::VectorXd solved = matrix.llt().solve(part);
    Eigen::VectorXd all = Eigen::VectorXd::Zero(right.size());
    for (Eigen::Index a = 0; a < n; ++a)
    {
      all(cells[static_cast<std::size_t>(a)]) = solved(a);
    }
    return all;
  }

  /// Violation of a cell [m]; zero if the cell is correct. A pressure is counted as the displacement of its own cell.
  static double violation(const State& s, std::size_t i)
  {
    constexpr double rounding = 1e-15;  // [m]
    const auto at = static_cast<Eigen::Index>(i);
    const double wrong = s.loaded[i] ? -s.pressure(at) * s.matrix(at, at) : -s.distance(at);
    return wrong > rounding ? wrong : 0;
  }

  int countWrong() const
  {
    int wrong = 0;
    for (const State& s : states_)
    {
      for (std::size_t i = 0; i < s.loaded.size(); ++i)
      {
        wrong += violation(s, i) > 0 ? 1 : 0;
      }
    }
    return wrong;
  }

  void change(bool all)
  {
    double worst = 0;
    for (const State& s : states_)
    {
      for (std::size_t i = 0; i < s.loaded.size(); ++i)
      {
        worst = std::max(worst, violation(s, i));
      }
    }
    for (State& s : states_)
    {
      for (std::size_t i = 0; i < s.loaded.size(); ++i)
      {
        const double wrong = violation(s, i);
        if (wrong > 0 && (all || wrong == worst))
        {
          s.loaded[i] = !s.loaded[i];
        }
      }
    }
  }

  const NormalProblem& problem_;
  std::vector<State> states_;
};
}  // namespace wheel_rail_contact::core::problems
