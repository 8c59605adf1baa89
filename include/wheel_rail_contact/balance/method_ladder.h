// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "wheel_rail_contact/balance/wheel_patch.h"
#include "wheel_rail_contact/config.h"
#include "wheel_rail_contact/normal/error_estimate.h"
#include "wheel_rail_contact/normal/normal_solver.h"

namespace wheel_rail_contact
{
/// A grid and what to expect of it.
struct Rung
{
  GridSize size;          ///< cells of the grid
  double ordinary_error;  ///< largest relative error that most scenes stay below [-]
  ErrorEstimate typical;  ///< estimates over those of the same scene on 24 × 56 cells, medians [-]
};

/// The normal method in use and the grids it may be used on, from coarse to fine. `method: auto` has conjugate
/// gradients on all of them; any other method has one, given by hand or by the tolerance.
class MethodLadder
{
 public:
  /// Copies what it needs of `config`; computes the coefficients of its grids.
  explicit MethodLadder(const ContactModelConfig& config);

  /// The method, for all rungs.
  NormalSolver& solver() const { return *solver_; }
  /// Number of rungs, >= 1.
  std::size_t count() const { return rungs_.size(); }
  /// From 0, the coarsest.
  const Rung& at(std::size_t rung) const { return rungs_[rung]; }
  /// For the first pass from cold, where planes and boxes are still rough.
  const Rung& rough() const { return rough_; }

 private:
  std::unique_ptr<NormalSolver> solver_;
  std::vector<Rung> rungs_;
  Rung rough_;
};

/// The rung that one wheel is on, kept from answer to answer.
class RungChoice
{
 public:
  /// @param tolerance  wanted relative error [-]
  RungChoice(const MethodLadder& ladder, double tolerance) : ladder_(&ladder), tolerance_(tolerance) {}

  /// The rung to solve on.
  const Rung& rung() const { return ladder_->at(rung_); }

  /// Sets out from cold, by the errors estimated on the rough grid: the rung that is promised to do, at most the one
  /// that does in ordinary scenes.
  void start(const ErrorEstimate& rough);
  /// Climbs if an estimated error is above the tolerance. @return true if there is a finer rung to solve on.
  bool climb(const ErrorEstimate& error);
  /// Takes a coarser rung for the next answer if that promises to do, by the largest of the last answers' estimates,
  /// which fade: one alone may be blind to a jump of curvature between its cells. After it had to climb back it waits,
  /// longer each time, unless the promise is far better than asked for.
  void descend(const ErrorEstimate& error);

 private:
  const MethodLadder* ladder_;
  double tolerance_;
  std::size_t rung_ = 0;
  ErrorEstimate lately_;    ///< largest estimates of late, as of 24 × 56 cells, fading
  bool descended_ = false;  ///< for the present answer
  int wait_ = 0;            ///< answers before the next try to descend
  int next_wait_ = first_wait;

  static constexpr int first_wait = 2;
  static constexpr int longest_wait = 64;
  static constexpr std::size_t longest_climb = 2;  ///< rungs at a time
  static constexpr double descend_reserve = 0.8;   ///< promised error over the tolerance when descending [-]
  static constexpr double fading = 0.9;            ///< of earlier estimates, with each answer [-]
  static constexpr double large_reserve = 0.4;     ///< the same while it waits [-]
};
}  // namespace wheel_rail_contact
