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
      state.loaded = Eigen::VectorXd::Ones(patch.gap.size());
      states_.push_back(std::move(state));
    }
  }

  Result solve()
  {
    Result result;
    Eigen::Index least = -1;
    int patience = 10;
    while (true)
    {
      solveLoaded(result.approach);
      ++result.factorisations;
      Eigen::Index wrong = 0;
      double worst = 0;
      for (State& s : states_)
      {
        // A pressure is counted as the displacement of its own cell.
        s.violation = (s.loaded.array() > 0).select(-s.pressure.cwiseProduct(s.matrix.diagonal()), -s.distance);
        wrong += (s.violation.array() > rounding).count();
        worst = std::max(worst, s.violation.maxCoeff());
      }
      if (wrong == 0)
      {
        break;
      }
      patience = least < 0 || wrong < least ? 10 : patience - 1;
      least = least < 0 ? wrong : std::min(least, wrong);
      for (State& s : states_)
      {
        const auto changes = s.violation.array() > (patience > 0 ? rounding : worst * (1 - 1e-15));
        s.loaded = changes.select(1 - s.loaded.array(), s.loaded.array()).matrix();
      }
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
    Eigen::VectorXd weight, gap, pressure, distance, response, closing, loaded, violation;
  };
  static constexpr double rounding = 1e-15;  ///< of distances [m]

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
      const auto factors = restricted(s.matrix, s.loaded).llt();
      s.response = factors.solve(s.loaded.cwiseProduct(s.weight));
      s.closing = factors.solve(s.loaded.cwiseProduct(s.gap));
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

  const NormalProblem& problem_;
  std::vector<State> states_;
};
}  // namespace wheel_rail_contact::core::problems
