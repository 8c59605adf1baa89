// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "core/balance/overlap_grids.h"
#include "core/balance/solved_contact.h"
#include "core/balance/tuning.h"
#include "core/normal/solvers/contact_tangent.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// Result of the contact of a wheel with its rail.
enum class WheelStatus
{
  solved,         ///< usable
  no_contact,     ///< the wheel is above the rail; usable
  beside_rail,    ///< no part of the wheel is above the rail
  normal_failed,  ///< the normal solution is not usable, see solution().status
  unbalanced,     ///< no height or deflection was found
};

/// True if the result may be used.
inline bool isUsable(WheelStatus status)
{
  return status == WheelStatus::solved || status == WheelStatus::no_contact;
}

/// Contact of one wheel with its rail, on the surface of the rail (OverlapGrids). Side axes.
class WheelContact
{
 public:
  /// Keeps references to `config` and `solver`, which must outlive the object.
  /// @param rail  its profile is the first one of the rail
  /// @param longest_rail  length of the longest profile of the rail [m]
  WheelContact(const ContactModelConfig& config, Side side, const PlacedRail& rail, NormalSolver& solver,
               double longest_rail = 0);

  /// Sets the number of cells of each grid, and its index. The next solution starts from the pressure of the last one
  /// with the same index.
  void setGrid(std::size_t level, const GridSize& size);
  /// The same for a finer grid, after a solution. The next grids cover the pressure of that solution.
  void refineTo(std::size_t level, const GridSize& size);
  /// Sets the position of the rail, as ContactSearch.
  void setRail(const PlacedRail& rail, bool reshaped = false) { grids_.setRail(rail, reshaped); }
  const PlacedRail& rail() const { return grids_.rail(); }

  /// Solves the contact at a pose.
  WheelStatus solveAt(const WheelsetPose& pose, OverlapGrids::Choice choice = OverlapGrids::Choice::own);
  /// Solves the contact under a load [N], > 0, with the gap of a pose. If the bodies do not overlap, the pose is first
  /// lowered.
  WheelStatus solveLoad(const WheelsetPose& pose, double load, OverlapGrids::Choice choice = OverlapGrids::Choice::own);
  /// Overlap of a ball of the wheel's radius with a plane under a load [N] (Hertz 1882): about that of the wheel [m].
  double typicalOverlap(double load) const;
  /// Finds the position of first touch at a pose, without load; height() is the height of the axle centre there.
  WheelStatus touch(const WheelsetPose& pose);

  /// Height of the axle centre in the last solution [m]. Under a load, the height to which the remaining approach
  /// leads.
  double height() const { return pose_.z - remaining(); }
  /// The wheel at this height.
  PlacedWheel wheel() const { return grids_.wheelAt(height()); }
  /// Height of the gap minus height() [m].
  double remaining() const { return solution_.approach; }
  /// True if the gap is so close to its final height that the solution is usable.
  bool isDeepEnough() const { return std::abs(remaining()) <= tuning::last_step * overlap(); }
  /// Largest overlap of the undeformed bodies [m].
  double overlap() const { return -grids_.touch().separation; }
  /// True if the grids are those of the final height, and cover no more than a complete contact requires. Otherwise the
  /// next solution is on such grids.
  bool hasOwnGrids();
  /// True if the pressure reaches the end of a profile.
  bool reachesEnd() const;

  /// Forces of the last solution.
  const SolvedContact& solved() const { return solved_; }
  /// Derivatives of the forces, see SolvedContact.
  /// @param residual  see ContactTangent
  MotionMatrix stiffness(double residual = tuning::last_step);
  /// Its row of the wheel's height alone, which takes a quarter of the products.
  MotionVector verticalStiffness();

  const OverlapGrids& grids() const { return grids_; }
  const CurvedProblem& problem() const { return problem_; }
  /// What the method leaves out of the problem, see NormalSolver::leftOut().
  std::string_view leftOut() const { return solver_.leftOut(problem_); }
  const NormalSolution& solution() const { return solution_; }
  /// Number of normal problems since the object was made.
  int solutions() const { return solutions_; }
  /// Number of products with the influence matrix for stiffnesses since the object was made.
  int stiffnessProducts() const { return tangent_.products(); }
  /// The next solutions start without the pressures of the last ones.
  void forget();

 private:
  OverlapGrids::Overlap build(OverlapGrids::Reach reach, OverlapGrids::Choice choice);
  void useGrid(std::size_t level, const GridSize& size, OverlapGrids::Reach reach);
  WheelStatus solve(NormalProblem::Control control, double value, OverlapGrids::Choice choice);
  void solveProblem();
  WheelStatus none(WheelStatus status);

  NormalSolver& solver_;
  double radius_;  ///< of the rolling circle [m]
  GridSize size_;
  std::size_t level_ = 0;
  OverlapGrids grids_;
  CurvedProblem problem_;
  NormalSolution solution_;
  std::vector<NormalSolution> kept_;  ///< last solutions on the other grids
  ContactTangent tangent_;
  WheelsetPose pose_;  ///< of the gap
  SolvedContact solved_;
  OverlapGrids::Reach first_reach_;                               ///< on the first grid
  OverlapGrids::Reach start_reach_ = OverlapGrids::Reach::whole;  ///< of the first solution on this grid
  OverlapGrids::Reach reach_ = OverlapGrids::Reach::whole;        ///< of the next solution: that of the last one
  /// The contact reached beyond smaller grids: in the last solution, or since refineTo(), where heights hardly change.
  bool needs_whole_ = false;
  int solutions_ = 0;
};
}  // namespace wheel_rail_contact::core
