// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/balance/patch_memory.h"
#include "core/balance/rail_support.h"
#include "core/balance/result_trend.h"
#include "core/track/contact_search.h"
#include "core/track/gap.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core
{
/// First touch of the rigid bodies, side axes.
struct RigidTouch
{
  bool found = false;      ///< false: the wheel is beside the rail
  double axle_height = 0;  ///< z of the axle centre at first touch, at y, yaw and roll of the pose [m]
  double lever = 0;        ///< -d(axle_height)/d(roll) with the bodies in contact [m]
  InitialContact contact;  ///< position of first touch
};

/// Forces of a wheel's contact on its rail, side axes.
struct WheelForces
{
  double outward = 0;   ///< outward force on the rail [N]
  double vertical = 0;  ///< downward force on the rail [N]
  double moment = 0;    ///< moment on the rail head about its reference point, outward roll positive [N m]
};

constexpr double flange_slope = 0.3;  ///< slope above which a contact counts as flange contact [-]

/// Result of a wheel's solution.
enum class WheelStatus
{
  solved,         ///< usable
  no_contact,     ///< the given height leaves the wheel above the rail, or the load is zero
  beside_rail,    ///< no part of the wheel is above the rail
  off_profile,    ///< pressure beyond the end of a profile
  box_not_found,  ///< no grid was found that covers the whole contact
  spike,          ///< on each grid a patch has pressure on fewer than three cells
  normal_failed   ///< the normal solution is not usable, see solution().status
};

/// Contact of one wheel with one rail, side axes. The gap is built with the wheel at its estimated penetration, because
/// the wheel slides along an inclined plane as it moves down. The normal solution determines only the rest. The class
/// finds the overlap intervals, lays a plane and a grid over each, and solves all of them at one penetration of the
/// wheel.
///
/// It stores the position of the last contact in the overlap interval and the angle of its plane relative to the
/// interval. This memory changes only in learn(), or if a box has cut the contact off. Otherwise the solution is a
/// smooth function of the placement. planeError() and boxFill() measure how well the stored planes and boxes still fit.
class WheelContact
{
 public:
  /// Keeps references to `config` and `solver`, which must outlive this.
  WheelContact(const ContactModelConfig& config, NormalSolver& solver);

  /// Sets the method of the next solutions; it must outlive this.
  void setSolver(NormalSolver& solver) { solver_ = &solver; }
  /// Method in use.
  const NormalSolver& solver() const { return *solver_; }

  /// Sets the position of the rail and its compliance there. `support.placed` are the coordinates of this position
  /// (rail_support.h). If a support has a compliance but is not solved with the contact, the forces displace it after
  /// the solution; the gap remains unchanged.
  void setRail(const PlacedRail& rail, const Support& support);
  /// Sets a rail without compliance.
  void setRail(const PlacedRail& rail) { setRail(rail, Support()); }
  /// Rail in its set position.
  const PlacedRail& rail() const { return *rail_; }

  /// First touch at a pose (its z is not used). The last result is cached.
  RigidTouch touch(const WheelsetPose& pose);

  /// Estimated penetration of the axle below the first touch under a vertical load [m]: from the last solution, or from
  /// Hertz with the curvatures of the separation over the width of the contact.
  double estimatePenetration(const RigidTouch& touch, double load) const;

  /// Solves the contact at the last pose passed to touch(), under a vertical load [N].
  WheelStatus solveLoad(const RigidTouch& touch, double load, const GridSize& size);
  /// Same for an axle `penetration` below the first touch [m].
  WheelStatus solvePenetration(const RigidTouch& touch, double penetration, const GridSize& size);

  /// Prepares another state, whose wheelset is `moved` to the side of the last result [m]. After a similar preceding
  /// step, the change of the contact is extrapolated from that step.
  void begin(double moved);
  /// Accepts the last solution as the result of the state.
  void finish();

  /// Stores the last solution in the memory. The next call lays its planes and boxes from it.
  void learn();

  /// Penetration of the axle below the first touch in the last solution, including the deflection of the rail from its
  /// set position [m].
  double penetration() const { return solution_.approach + deflected_; }
  /// Penetration without this deflection [m].
  double elasticPenetration() const { return solution_.approach; }
  /// Part of the penetration due to this deflection; zero after the rail has been set again [m].
  double deflected() const { return deflected_; }
  /// Forces of the last solution.
  const WheelForces& forces() const { return forces_; }
  /// Coordinates of the rail in the last solution; without a compliance those of its set position.
  const Eigen::Vector3d& support() const { return problem_.support.placed; }
  /// Displacement (y, z) of the rail at the origin of a patch, from its set position to the last solution, side axes
  /// [m].
  Eigen::Vector2d railDisplacement(const WheelPatch& patch) const;
  /// Largest of these displacements along the planes of the patches; the gaps contain them only to first order [m].
  double railSlip() const;
  /// Height of the force-weighted mean of the patch origins above the reference point of the rail head [m].
  double heightOverReference() const;
  /// Approach of a patch along its normal, from its own first touch. At least the overlap of its gap, also between the
  /// cells (leastGap()) [m].
  double patchApproach(std::size_t patch) const;
  /// Force-weighted mean angle between the planes and the pressure-weighted normals [rad].
  double planeError() const;
  /// Estimates the errors of the last solution, one entry per patch.
  const std::vector<ErrorEstimate>& estimateErrors();
  /// Result of the last estimateErrors().
  const std::vector<ErrorEstimate>& errors() const { return errors_; }
  /// Estimated relative error of a patch in the last solution that is due to remaining errors of the balance [-]:
  /// - Penetration. If the solved penetration differs by D from that of the gap, the wheel slides by D sin(angle) along
  ///   the plane. This opens the gap by the same distance times the slope of the surface. The error is the uneven part
  ///   of this opening over twice the approach. The wheel also slides if its rail deflects downward, and if it rolls.
  /// - Plane. If the plane is off by a small angle, the relative error of the normal force is this angle times the
  ///   tangent of the contact angle.
  /// - Roll. A remaining roll error `open_roll` [rad] also moves the patches of a wheel relative to one another, by the
  ///   difference of their lever arms along the normal.
  double layoutError(std::size_t patch, double open_roll) const;
  /// Part of layoutError() due to a remaining roll error [rad]: the largest of all patches [-].
  double rollError(double open_roll) const;
  /// Part of layoutError() due to the sliding of the wheel along the planes since the gaps were built: the largest of
  /// all patches [-].
  double slipError() const;
  /// Part of slipError() due to the deflection of the rail from its set position: the largest of all patches [-].
  double deflectionError() const;
  /// Half-space ratio of a patch: half the angle through which the section of the wheel or the rail, whichever is
  /// larger, turns over the pressure. On an arc it is the half-width of the pressure over the radius [rad].
  double halfSpaceRatio(std::size_t patch) const;
  /// Relative difference of the solved penetration from that of the gap [-].
  double penetrationError() const;
  /// Smallest ratio of the length or width of a pressure to the expected one of its grid [-].
  double boxFill() const { return box_fill_; }
  /// True if a box of the last call was widened because pressure was missed. The box may then be too large.
  bool widened() const { return widened_; }
  /// -d(axle height)/d(roll) at constant load [m].
  double lever() const;
  /// d(axle height)/dy at constant load: load-weighted slope of the planes [-].
  double heightSlope() const;
  /// True if a loaded plane differs by more than 0.1 rad from the normal of its first touch. Rigid contact then does
  /// not predict the movement of the axle.
  bool tilts() const;
  /// Number of solved normal problems.
  int solutions() const { return solutions_; }

  /// Patches of the last solution.
  const std::vector<WheelPatch>& patches() const { return patches_; }
  /// Problem of the last solution, one patch for each of patches().
  const NormalProblem& problem() const { return problem_; }
  /// Last solution.
  const NormalSolution& solution() const { return solution_; }

  /// Discards the last result.
  void reset();

 private:
  WheelStatus solve(const RigidTouch& touch, const GridSize& size);
  bool layBoxes(const RigidTouch& touch, const GridSize& size);
  PatchMemory& recall(const OverlapInterval& interval);
  WheelForces sumOfForces() const;
  void settleSupport();
  void takeIntoGaps(const Eigen::Vector3d& move);
  void measure();
  double leverOf(const WheelPatch& patch) const;
  double rollError(std::size_t patch, double open_roll) const;
  double slipError(std::size_t patch, double slip) const;
  double slip(const WheelPatch& patch) const;
  double deflectionSlip(const WheelPatch& patch) const;
  void findStations(std::size_t patch, double separation);
  bool missesPressure(const RigidTouch& touch);
  bool boxesHold(const RigidTouch& touch);

  const ContactModelConfig& config_;
  NormalSolver* solver_;
  double modulus_;
  ContactSearch search_;
  std::optional<PlacedRail> rail_;
  std::optional<PlacedWheel> wheel_;
  std::optional<RigidTouch> touch_;         ///< for this wheel and this rail; empty after setRail()
  std::vector<OverlapInterval> intervals_;  ///< scratch
  std::vector<Station> stations_;
  std::vector<WheelPatch> patches_;
  std::vector<PatchMemory> memory_;
  NormalProblem problem_;
  NormalSolution solution_;
  std::vector<ErrorEstimate> errors_;
  WheelForces forces_;  ///< of the last solution
  Support support_;
  double deflected_ = 0;          ///< penetration due to the deflection of the rail in the last solution [m]
  double touch_separation_ = 0;   ///< separation at the first touch for which the boxes were laid [m]
  double boxed_penetration_ = 0;  ///< penetration for which the boxes were laid [m]
  double box_fill_ = 1;
  bool box_cut_ = false;
  bool spike_ = false;  ///< the last solution has too few loaded cells
  bool widened_ = false;
  ResultTrend trend_;
  double expected_ = 1;   ///< expected penetration of the present state over that of the last result [-]
  WheelsetPose learned_;  ///< pose of the wheel at which the memory was stored
  bool held_ = false;     ///< the wheel is at that pose, except for its height
  double load_ = 0;       ///< load of the last usable solution [N]; 0: none
  int solutions_ = 0;
};
}  // namespace wheel_rail_contact::core
