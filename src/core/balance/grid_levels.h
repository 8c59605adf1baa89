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
/// A method on a grid, with its expected errors.
struct GridLevel
{
  GridSize size;          ///< cells of the grid
  double ordinary_error;  ///< relative error that 98 % of ordinary patches do not exceed [-]
  /// Error estimates relative to those of the same patch on 24 × 56 cells. Each is the median over the patches in which
  /// this error dominates. The area part excludes the error of narrow ends [-].
  ErrorEstimate typical;
  NormalSolver* solver = nullptr;  ///< the method
};

/// The normal method and the grids on which it may be used, in the order of their cost. `method: auto` uses conjugate
/// gradients on all of them. In addition it has Hertz's closed form, which is cheaper than any grid and exact between
/// round bodies. Every other method has one grid, set by hand or chosen by the tolerance.
class GridLevels
{
 public:
  /// Receives the method of the grids and returns the solver to be used instead, for observation or timing.
  using Wrap = std::function<std::unique_ptr<NormalSolver>(std::unique_ptr<NormalSolver>)>;

  /// Copies the required values of `config` and computes the coefficients of its grids. A balance that uses these
  /// levels needs the same method, grid, tolerance and rail bending.
  explicit GridLevels(const ContactModelConfig& config, const Wrap& wrap = nullptr);

  /// Method of the grids.
  NormalSolver& solver() const { return *solver_; }
  /// Number of grids, >= 1.
  std::size_t count() const { return levels_.size(); }
  /// Grid level by index; 0 is the cheapest grid.
  const GridLevel& at(std::size_t level) const { return levels_[level]; }
  /// Grid of the first pass of a cold start, in which planes and boxes are still rough.
  const GridLevel& rough() const { return rough_; }
  /// Hertz's closed form. Null except for `method: auto` on rails that do not bend by a table: the closed form cannot
  /// be solved together with such a rail.
  const GridLevel* closedForm() const { return hertz_ ? &closed_form_ : nullptr; }

 private:
  std::unique_ptr<NormalSolver> solver_;
  std::unique_ptr<HertzSolver> hertz_;
  std::vector<GridLevel> levels_;
  GridLevel rough_;
  GridLevel closed_form_;
};

/// Grid level of one wheel, kept from result to result.
class GridLevelChoice
{
 public:
  static constexpr std::size_t most_levels = 32;  ///< upper limit of GridLevels::count()

  /// @param tolerance  required relative error [-]
  GridLevelChoice(const GridLevels& levels, double tolerance) : levels_(&levels), tolerance_(tolerance) {}

  /// Level for the next solution.
  const GridLevel& level() const { return closed_form_ ? *levels_->closedForm() : levels_->at(level_); }

  /// Cold start: chooses the cheapest level whose predicted error meets the tolerance, or which meets it for ordinary
  /// patches. The prediction uses the errors estimated on the rough grid. Levels that have failed at this position are
  /// skipped. The closed form may be tried at once.
  void start(const ErrorEstimate& rough);
  /// Prepares a result at a lateral position of the wheelset [m]. If the present level has recently failed at this
  /// position, takes the next one that has not. Coarse grids fail where a profile changes its curvature, and a hunting
  /// wheelset returns to the same positions.
  void arrive(double place);
  /// If the estimated error exceeds the tolerance, changes to a finer level whose predicted error meets the tolerance;
  /// directly after coarsening, no further than back to the previous level. A closed form whose estimated error exceeds
  /// its limit is replaced by the grid.
  /// @return true if there is another level to solve on
  bool refine(const ErrorEstimate& error);
  /// Chooses the cheapest level for the next result whose predicted error meets the tolerance. The prediction uses the
  /// largest of the recent estimates, which decay, because a single estimate may miss a curvature jump between its
  /// cells. After a coarser level has failed, waits before the next try, longer each time, unless the predicted error
  /// is far below the tolerance.
  void coarsen(const ErrorEstimate& error);
  /// Chooses the closed form for the next solution if its predicted error is small enough for this one, which was found
  /// on a grid. Otherwise it is tried again some results later.
  void tryClosedForm(const NormalProblem& problem, const NormalSolution& solution);
  /// Returns to the last grid. @return false if a grid is already in use
  bool leaveClosedForm();

 private:
  static constexpr long remembered = 64;  ///< results for which a failure is stored; a power of two
  static constexpr std::size_t no_level = static_cast<std::size_t>(-1);

  /// Levels that were too coarse at one position.
  struct Failure
  {
    long place = 0;                        ///< lateral position, in units of same_place
    long result = -remembered;             ///< index of the result of the last failure; the initial value means none
    std::bitset<most_levels> levels;       ///< levels that failed
    ErrorEstimate normal;                  ///< error on 24 × 56 cells predicted from the last failure
    std::size_t met_tolerance = no_level;  ///< level that has met the tolerance since, whatever its predicted error
  };

  double closedFormLimit() const;
  /// Recent failures at this position; null if there are none.
  const Failure* failureHere() const;
  /// True if the level has recently failed at this position, or if its error predicted from the failure clearly exceeds
  /// the tolerance.
  bool failsHere(std::size_t level) const;
  /// The first level above the present one, up to `highest`, whose predicted error meets the tolerance. If there is
  /// none, the level with the least predicted error. If none is predicted to be better than the present estimate, the
  /// first level beyond `highest` that is (not directly after coarsening), or else the next level. Levels that failed
  /// here are skipped.
  std::size_t nextLevel(const ErrorEstimate& normal, std::size_t highest) const;
  static std::size_t slot(long place) { return static_cast<std::size_t>(place & (remembered - 1)); }

  const GridLevels* levels_;
  double tolerance_;
  std::size_t level_ = 0;     ///< index of the grid
  bool closed_form_ = false;  ///< the closed form is used instead of the grid
  int closed_form_wait_ = 0;  ///< results until the closed form is tried again
  ErrorEstimate recent_;      ///< largest recent estimates, converted to 24 × 56 cells, decaying
  bool coarsened_ = false;    ///< the level was made coarser for the present result
  std::size_t before_ = 0;    ///< level before the last coarsening
  int wait_ = 0;              ///< results until the next try to coarsen
  int next_wait_ = first_wait;
  long place_ = 0;    ///< present lateral position, in units of same_place
  long results_ = 0;  ///< number of results
  std::vector<ErrorEstimate> scratch_;

  static constexpr double same_place = 5e-5;  ///< distance of the positions at which failures are stored [m]
  std::array<Failure, remembered> failures_{};

  static constexpr double clear_failure = 1.5;  ///< predicted error over the tolerance [-]
  static constexpr int first_wait = 2;
  static constexpr int longest_wait = 64;
  static constexpr std::size_t longest_refinement = 4;  ///< in one refinement
  static constexpr double coarsen_reserve = 0.8;        ///< predicted error over the tolerance at which to coarsen [-]
  static constexpr double large_reserve = 0.4;          ///< the same during the wait [-]
  static constexpr double decay = 0.9;                  ///< factor of earlier estimates per result [-]
  /// Error of Hertz's solution up to which bodies count as round [-]. Between less round bodies the passes of a
  /// wheelset converge later with the Hertz ellipse, which follows the curvature at a single point, than on a coarse
  /// grid: S1002 at 3 and 10 % took a quarter more time.
  static constexpr double round_enough = 0.004;
  static constexpr int between_tries = 16;  ///< results between two tries of the closed form
};
}  // namespace wheel_rail_contact::core
