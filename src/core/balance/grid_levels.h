// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Number of cells of a grid.
struct GridSize
{
  int along = 0;   ///< along the track
  int across = 0;  ///< across the track
};

/// Equality of both numbers.
inline bool operator==(const GridSize& one, const GridSize& other)
{
  return one.along == other.along && one.across == other.across;
}

/// Tolerance of the first grids and of the searches [-]. With a given height, errors of the grids and of the deflection
/// are errors of the forces, and make them fall where the wheel is lowered a little: it is therefore limited.
double searchTolerance(const ContactModelConfig& config);

/// The normal method and the grids on which it is used.
///
/// Every solution starts on the same grid, which the tolerance determines: the error of a smooth contact is of the
/// order of 1 / (cells along)². With `method: auto`, a wheel whose estimated error exceeds the tolerance is solved
/// again on a finer grid. Nothing depends on earlier results. Every other method has one grid, for half the expected
/// error.
class GridLevels
{
 public:
  /// Receives the method and returns the solver to be used instead, for observation or timing.
  using Wrap = std::function<std::unique_ptr<NormalSolver>(std::unique_ptr<NormalSolver>)>;

  /// Copies the required values of `config` and computes the coefficients of its grids.
  explicit GridLevels(const ContactModelConfig& config, const Wrap& wrap = nullptr);

  /// Method of the grids.
  NormalSolver& solver() const { return *solver_; }
  /// Number of grids, >= 1. The first one is used first.
  std::size_t count() const { return sizes_.size(); }
  /// Grid by index.
  const GridSize& at(std::size_t level) const { return sizes_[level]; }
  /// The level on which the error is expected to meet the tolerance. `level` itself if it meets the tolerance, or if
  /// there is no finer one. The errors that require a finer grid are those of a peak of few cells. They fall with the
  /// square of its bend, which is as the square of the number of cells.
  /// @param error  estimated error on `level` [-]
  std::size_t finer(std::size_t level, double error) const;

 private:
  double tolerance_;
  std::unique_ptr<NormalSolver> solver_;
  std::vector<GridSize> sizes_;
};
}  // namespace wheel_rail_contact::core
