// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bitset>
#include <functional>
#include <memory>
#include <vector>

#include "core/balance/wheel_patch.h"
#include "core/normal/estimate/error_estimate.h"
#include "core/normal/solvers/hertz_solver.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// A method on a grid, and what to expect of it.
struct GridLevel
{
  GridSize size;          ///< cells of the grid
  double ordinary_error;  ///< largest relative error that 98 % of ordinary patches stay below [-]
  /// Estimates over those of the same patch on 24 × 56 cells, each the median over the patches that it decides; of the
  /// area what the tails do not make [-].
  ErrorEstimate typical;
  NormalSolver* solver = nullptr;  ///< the method
};

/// The normal method in use and the grids it may be used on, in the order of their cost. `method: auto` has conjugate
/// gradients on all of them, and Hertz's closed form beside, which costs less than any and is exact between round
/// bodies; any other method has one grid, given by hand or by the tolerance.
class GridLevels
{
 public:
  /// Puts another solver in the place of the grids' method, which it is given, to watch or to time it.
  using Wrap = std::function<std::unique_ptr<NormalSolver>(std::unique_ptr<NormalSolver>)>;

  /// Copies what it needs of `config`, of which a balance that uses the ladder needs the same method, grid, tolerance
  /// and rail bending; computes the coefficients of its grids.
  explicit GridLevels(const ContactModelConfig& config, const Wrap& wrap = nullptr);

  /// The method of the grids.
  NormalSolver& solver() const { return *solver_; }
  /// Number of grids, >= 1.
  std::size_t count() const { return levels_.size(); }
  /// From 0, the cheapest grid.
  const GridLevel& at(std::size_t level) const { return levels_[level]; }
  /// For the first pass from cold, where planes and boxes are still rough.
  const GridLevel& rough() const { return rough_; }
  /// Hertz, in place of any grid; null but for `method: auto` on rails that do not bend by a table, which a closed form
  /// does not solve together with the contact.
  const GridLevel* closedForm() const { return hertz_ ? &closed_form_ : nullptr; }

 private:
  std::unique_ptr<NormalSolver> solver_;
  std::unique_ptr<HertzSolver> hertz_;
  std::vector<GridLevel> levels_;
  GridLevel rough_;
  GridLevel closed_form_;
};

/// The rung that one wheel is on, kept from answer to answer.
class GridLevelChoice
{
 public:
  static constexpr std::size_t most_levels = 32;  ///< of a ladder

  /// @param tolerance  wanted relative error [-]
  GridLevelChoice(const GridLevels& levels, double tolerance) : levels_(&levels), tolerance_(tolerance) {}

  /// The rung to solve on.
  const GridLevel& level() const { return closed_form_ ? *levels_->closedForm() : levels_->at(level_); }

  /// Sets out from cold, by the errors estimated on the rough grid: the cheapest rung that is promised to do or that
  /// does in ordinary scenes, unless it is known to fail here. The closed form may be tried at once.
  void start(const ErrorEstimate& rough);
  /// Sets out for an answer with the wheelset at a place across the track [m]: where the rung has failed of late, one
  /// that does is taken at once. It is where profiles change their curvature that coarse grids fail, and a wheelset
  /// that runs to and fro comes by again.
  void arrive(double place);
  /// If an estimated error is above the tolerance, climbs to the next rung that promises to do; after a descent, no
  /// farther than back. @return true if there is another rung to solve on.
  bool refine(const ErrorEstimate& error);
  /// Takes the cheapest rung for the next answer that promises to do, by the largest of the last answers' estimates,
  /// which fade: one alone may be blind to a jump of curvature between its cells. After it had to climb back it waits,
  /// longer each time, unless the promise is far better than asked for.
  void coarsen(const ErrorEstimate& error);
  /// Takes the closed form for the next solution if it promises to do for this one, found on a grid. Where it does not,
  /// it is asked again some answers later.
  void tryClosedForm(const NormalProblem& problem, const NormalSolution& solution);
  /// Goes back to the grid it was on. @return false if it is on one.
  bool leaveClosedForm();

 private:
  static constexpr long remembered = 64;  ///< answers for which a failure is remembered; a power of two
  static constexpr std::size_t no_level = static_cast<std::size_t>(-1);

  /// What was too coarse at a place.
  struct Failure
  {
    long place = 0;                   ///< in units of same_place
    long result = -remembered;        ///< of the last failure; from the start none has failed
    std::bitset<most_levels> levels;  ///< that failed
    ErrorEstimate normal;             ///< what the last of them promised on 24 × 56 cells
    std::size_t did = no_level;       ///< one that did since, whatever was promised
  };

  double closedFormLimit() const;
  /// Failures at this place, not too long ago; null if there are none.
  const Failure* failureHere() const;
  /// The rung failed at this place of late, or what did promises that it would, clearly.
  bool failsHere(std::size_t level) const;
  /// The first rung above the present one, up to `highest`, that promises to do; if none does, the best of them; if
  /// none promises better than the present one has shown, the first beyond that does (not after a descent), or else the
  /// next. Those that failed here are passed over.
  std::size_t nextLevel(const ErrorEstimate& normal, std::size_t highest) const;
  static std::size_t slot(long place) { return static_cast<std::size_t>(place & (remembered - 1)); }

  const GridLevels* levels_;
  double tolerance_;
  std::size_t level_ = 0;     ///< of the grids
  bool closed_form_ = false;  ///< in place of the grid
  int closed_form_wait_ = 0;  ///< answers before it is asked again
  ErrorEstimate lately_;      ///< largest estimates of late, as of 24 × 56 cells, fading
  bool coarsened_ = false;    ///< for the present answer
  std::size_t before_ = 0;    ///< the rung that it has descended from
  int wait_ = 0;              ///< answers before the next try to descend
  int next_wait_ = first_wait;
  long place_ = 0;    ///< in units of same_place
  long results_ = 0;  ///< so far
  std::vector<ErrorEstimate> scratch_;

  static constexpr double same_place = 5e-5;  ///< [m]
  std::array<Failure, remembered> failures_{};

  static constexpr double clear_failure = 1.5;  ///< promised error over the tolerance [-]
  static constexpr int first_wait = 2;
  static constexpr int longest_wait = 64;
  static constexpr std::size_t longest_refinement = 4;  ///< rungs at a time, if one of them promises better
  static constexpr double coarsen_reserve = 0.8;        ///< promised error over the tolerance when descending [-]
  static constexpr double large_reserve = 0.4;          ///< the same while it waits [-]
  static constexpr double fading = 0.9;                 ///< of earlier estimates, with each answer [-]
  /// Error of Hertz up to which bodies count as round [-]. Where they are less so, a wheelset's passes settle later by
  /// its ellipse, which follows the curvature of a single place, than on a coarse grid: S1002 at 3 and 10 % took a
  /// quarter more time.
  static constexpr double round_enough = 0.004;
  static constexpr int between_tries = 16;  ///< answers from one look at the closed form to the next
};
}  // namespace wheel_rail_contact::core
