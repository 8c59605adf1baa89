// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/balance/overlap_grids.h"
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

/// Coordinates of wheel and rail. The forces along them are the wheel's load [N], its moment about the axle centre
/// [N m], and the outward force [N], the upward force [N] and the moment about the reference point of the head [N m] on
/// the rail. Side axes.
enum Motion
{
  wheel_up,      ///< wheel upwards [m]
  wheel_roll,    ///< roll about the axle centre [rad]
  rail_lateral,  ///< rail head outward [m]
  rail_up,       ///< rail head upwards [m]
  rail_roll,     ///< roll of the rail head about its reference point [rad], outward positive
  motions
};
using MotionVector = Eigen::Matrix<double, motions, 1>;
using MotionMatrix = Eigen::Matrix<double, motions, motions>;

/// Contact of one wheel with its rail, on the surface of the rail (OverlapGrids). Side axes.
///
/// The forces follow from the derivatives of the gap (SurfaceColumn); they are therefore the derivatives of the elastic
/// energy.
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
  /// Sets which grids are used.
  void choose(OverlapGrids::Choice choice) { choice_ = choice; }
  /// Sets another profile of the rail. setRail() must follow.
  void setProfile(const Profile& rail) { grids_.setProfile(rail); }
  /// Sets the position of the rail.
  void setRail(const PlacedRail& rail) { grids_.setRail(rail); }
  const PlacedRail& rail() const { return grids_.rail(); }

  /// Solves the contact at a pose.
  WheelStatus solveAt(const WheelsetPose& pose);
  /// Solves the contact under a load [N], > 0, with the gap of a pose. If the bodies do not overlap, the pose is first
  /// lowered.
  WheelStatus solveLoad(const WheelsetPose& pose, double load);
  /// Overlap of a wheel on a rail under a load [N], approximately [m].
  static double typicalOverlap(double load);
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
  bool isDeepEnough() const { return std::abs(remaining()) <= tuning::remaining_approach * overlap(); }
  /// Largest overlap of the undeformed bodies [m].
  double overlap() const { return -grids_.touch().separation; }
  /// Elastic energy [J].
  double energy() const { return energy_; }
  /// Forces along the coordinates, in the last solution.
  const MotionVector& forces() const { return forces_; }
  /// Derivatives of the forces with respect to the coordinates, with negative sign: elastic part (ContactTangent) and
  /// geometric part. Zero without pressure.
  /// @param residual  see ContactTangent
  MotionMatrix stiffness(double residual = tuning::rough_residual);
  /// Its row of the wheel's height alone, which takes a quarter of the products.
  MotionVector verticalStiffness();
  /// Height change of the axle centre per unit of a coordinate, under the same load and with the distribution of the
  /// pressure kept.
  double heightPer(Motion motion) const { return -forces_[motion] / forces_[wheel_up]; }
  /// Mean height of the columns over the reference point of the rail head, weighted with their normal forces [m].
  double heightOverReference() const;
  /// Largest opening of the gap under the pressure by a movement [m]. If the load is given, besides the one that a
  /// height change under the same load removes.
  double opening(const MotionVector& move) const;

  /// True if the grids are those of the final height, and cover no more than a complete contact requires. Otherwise the
  /// next solution is on such grids.
  bool hasOwnGrids();
  /// True if the pressure reaches the end of a profile.
  bool reachesEnd() const;
  /// Largest turn of the normal of wheel or rail over the loaded columns `first` to `last` of a patch, halved [rad].
  double halfSpaceRatio(std::size_t patch, Eigen::Index first, Eigen::Index last) const;

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
  OverlapGrids::Overlap build(OverlapGrids::Reach reach);
  WheelStatus solve(NormalProblem::Control control, double value);
  void solveProblem();
  WheelStatus none(WheelStatus status);
  void evaluate();
  void openings(std::size_t patch);
  void selectOpenings();
  MotionMatrix geometricStiffness() const;

  NormalSolver& solver_;
  GridSize size_;
  std::size_t level_ = 0;
  OverlapGrids grids_;
  CurvedProblem problem_;
  NormalSolution solution_;
  std::vector<NormalSolution> kept_;  ///< last solutions on the other grids
  ContactTangent tangent_;
  WheelsetPose pose_;                      ///< of the gap
  std::vector<Eigen::ArrayXXd> openings_;  ///< for each patch ny × motions
  std::vector<Eigen::ArrayXXd> tangent_openings_;
  std::vector<Eigen::VectorXd> column_forces_;  ///< for each patch [N]
  MotionVector forces_ = MotionVector::Zero();
  double energy_ = 0;
  OverlapGrids::Choice choice_ = OverlapGrids::Choice::own;
  OverlapGrids::Reach first_reach_;                               ///< on the first grid
  OverlapGrids::Reach start_reach_ = OverlapGrids::Reach::whole;  ///< since setGrid()
  OverlapGrids::Reach reach_ = OverlapGrids::Reach::whole;        ///< of the next solution: that of the last one
  int solutions_ = 0;
};
}  // namespace wheel_rail_contact::core
