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
/// First touch of rigid bodies, side axes.
struct RigidTouch
{
  bool found = false;      ///< false: the wheel is beside the rail
  double axle_height = 0;  ///< z of the axle centre at which wheel and rail touch, at the pose's y, yaw and roll [m]
  double lever = 0;        ///< -d(axle_height)/d(roll) with the bodies in touch [m]
  InitialContact contact;  ///< where they touch
};

/// What a wheel's contact does to its rail, side axes.
struct WheelForces
{
  double outward = 0;   ///< on the rail [N]
  double vertical = 0;  ///< on the rail, down [N]
  double moment = 0;    ///< on the rail head about its reference point, outward roll positive [N m]
};

constexpr double flange_slope = 0.3;  ///< of a contact, above which it is the flange's [-]

/// Why a wheel's solution ended.
enum class WheelStatus
{
  solved,         ///< usable
  no_contact,     ///< asked height leaves the wheel above the rail, or no load was asked for
  beside_rail,    ///< wheel and rail share no stretch of the track's width
  off_profile,    ///< pressure beyond the end of a profile
  box_not_found,  ///< no grid was found that holds all of the contact
  spike,          ///< no grid was found on which three cells carry a patch's pressure
  normal_failed   ///< the normal solution is not usable, see solution().status
};

/// Contact of one wheel with one rail in side axes. The gap is built with the wheel at its descent as far as it is
/// known, so that the wheel's way along an inclined plane counts, and only the rest is left to the normal solution.
/// Finds the stretches that overlap, lays a plane and a grid over each, and solves all of them at one descent of the
/// wheel.
///
/// Remembers, relative to the overlapping stretch, where in it the last contact lay and how its plane was turned.
/// Memory changes only where learn() is called (or a box has cut the contact off): between, the solution is a smooth
/// function of the placement. planeError() and boxFill() tell how well the remembered planes and boxes still fit.
class WheelContact
{
 public:
  /// Refers to `config` and `solver`, which must outlive it.
  WheelContact(const ContactModelConfig& config, NormalSolver& solver);

  /// Solves by another method from now on; it must outlive this.
  void setSolver(NormalSolver& solver) { solver_ = &solver; }
  /// The method in use.
  const NormalSolver& solver() const { return *solver_; }

  /// Sets the rail where it is, and how it yields there: then `support.placed` are its coordinates (rail_support.h). A
  /// support that has a compliance but does not yield in the solution is let down by the forces found, its gap kept.
  void setRail(const PlacedRail& rail, const Support& support);
  /// Sets a rail that stays where it is.
  void setRail(const PlacedRail& rail) { setRail(rail, Support()); }
  /// As it is set.
  const PlacedRail& rail() const { return *rail_; }

  /// First touch at a pose (its z is not used). Costs nothing where the last one was asked for.
  RigidTouch touch(const WheelsetPose& pose);

  /// Estimated descent of the axle below the first touch under a vertical load [m]: from the last solution, or Hertz
  /// with the curvatures that the separation has over the contact's own width.
  double estimatePenetration(const RigidTouch& touch, double load) const;

  /// Solves the contact at the pose last given to touch() under a vertical load [N].
  WheelStatus solveLoad(const RigidTouch& touch, double load, const GridSize& size);
  /// The same with the axle `descent` below the first touch [m].
  WheelStatus solvePenetration(const RigidTouch& touch, double penetration, const GridSize& size);

  /// Sets out for another state, whose wheelset stands `moved` farther to the side than in the last answer [m]. After a
  /// step like the one before, contacts are expected to change as in that one.
  void begin(double moved);
  /// Takes the last solution for the answer to the state.
  void finish();

  /// Takes the last solution over into memory: the next call lays its planes and boxes after it.
  void learn();

  /// Descent of the axle below the first touch in the last solution, with what the rail has yielded from where it was
  /// set [m].
  double penetration() const { return solution_.approach + deflected_; }
  /// The part of it that is left if the rail is set where it has yielded to [m].
  double elasticPenetration() const { return solution_.approach; }
  /// The rest; none once the rail is set anew [m].
  double deflected() const { return deflected_; }
  /// Of the last solution.
  const WheelForces& forces() const { return forces_; }
  /// Coordinates of the rail in the last solution: those it was set to, unless it yields.
  const Eigen::Vector3d& support() const { return problem_.support.placed; }
  /// Way of the rail at a patch's origin from where it was set to the last solution, side axes (y, z) [m].
  Eigen::Vector2d railDisplacement(const WheelPatch& patch) const;
  /// Longest of these ways along the patches' planes: the gaps know it to first order [m].
  double railSlip() const;
  /// How much a small way of the rail would change the last contact, as a part of its size: by what it opens the gap
  /// unevenly over the pressure, over twice the approach. In a Hertz contact that is the pressure's shift over its
  /// half-width. Infinite on the flange, and if the way could bring another stretch into contact, which is looked at
  /// only below `limit` [-].
  double effectOf(const Eigen::Vector3d& way, double limit);
  /// Height of the forces' mean place over the rail head's reference point [m].
  double heightOverReference() const;
  /// Approach of a patch along its normal, from its own first touch on, at least what its gap overlaps, between
  /// the cells as well (leastGap()) [m].
  double patchApproach(std::size_t patch) const;
  /// Load-weighted mean angle by which planes are off the pressure-weighted normal [rad].
  double planeError() const;
  /// Estimates the errors of the last solution, of each of its patches.
  const std::vector<ErrorEstimate>& estimateErrors();
  /// As last estimated.
  const std::vector<ErrorEstimate>& errors() const { return errors_; }
  /// Estimated relative error of a patch in the last solution by what its layout leaves open [-].
  ///
  /// A gap is built for the descent known beforehand. If the one found differs by D, the wheel slides by D sin(angle)
  /// along the plane, which opens the gap by that times the surface's slope: its uneven part counts over twice the
  /// approach. A wheel that comes down because its rail yields slides as well, and so does one that rolls. A plane that
  /// is off by an angle takes the normal force off by its tangent's share. A roll left open [rad] also moves the
  /// patches of a wheel against one another, by the difference of their levers along the normal.
  double layoutError(std::size_t patch, double open_roll) const;
  /// The part of it that a roll left open [rad] makes, the largest of all patches' [-].
  double rollError(double open_roll) const;
  /// The part of it by what the wheel has slid along the planes since the gaps were built, the largest of all patches'
  /// [-].
  double slipError() const;
  /// The part of that by what the wheel slides as the rail yields from where it was set, the largest of all patches'
  /// [-].
  double deflectionError() const;
  /// How far a patch is from a contact of half-spaces: half the angle through which the section of the wheel or the
  /// rail, whichever is larger, turns over the pressure; on an arc, the pressure's half-width over the radius [rad].
  double halfSpaceRatio(std::size_t patch) const;
  /// Solved descent against the one that the gap was built for, relative [-].
  double penetrationError() const;
  /// Smallest ratio of a pressure's length or width to those its grid was laid for [-].
  double boxFill() const { return box_fill_; }
  /// A box of the last call had to be widened for pressure that its first form missed, and may be loose now.
  bool widened() const { return widened_; }
  /// -d(axle height)/d(roll) at constant load [m].
  double lever() const;
  /// d(axle height)/dy at constant load: the load-weighted slope of the planes [-].
  double rise() const;
  /// True if the load is carried elsewhere than where the bodies touch first: rigid touch then does not tell how the
  /// axle moves.
  bool tilts() const;
  /// Normal problems solved so far.
  int solutions() const { return solutions_; }

  /// Of the last solution.
  const std::vector<WheelPatch>& patches() const { return patches_; }
  /// The last one solved, a patch for each of patches().
  const NormalProblem& problem() const { return problem_; }
  /// Its solution.
  const NormalSolution& solution() const { return solution_; }

  /// Forgets the last answer.
  void reset();

 private:
  WheelStatus solve(const RigidTouch& touch, const GridSize& size);
  bool layBoxes(const RigidTouch& touch, const GridSize& size);
  PatchMemory& recall(const OverlapInterval& interval);
  WheelForces sumOfForces() const;
  void settleSupport();
  void takeIntoGaps(const Eigen::Vector3d& way);
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
  std::optional<RigidTouch> touch_;         ///< of that wheel and that rail; none if the rail has been set anew
  std::vector<OverlapInterval> intervals_;  ///< scratch
  std::vector<Station> stations_;
  std::vector<WheelPatch> patches_;
  std::vector<PatchMemory> memory_;
  NormalProblem problem_;
  NormalSolution solution_;
  std::vector<ErrorEstimate> errors_;
  WheelForces forces_;  ///< in the last solution
  Support support_;
  double deflected_ = 0;          ///< descent that the rail's yielding has added in the last solution [m]
  double touch_separation_ = 0;   ///< of the first touch that the boxes were laid for [m]
  double boxed_penetration_ = 0;  ///< descent for which the boxes were laid [m]
  double box_fill_ = 1;
  bool box_cut_ = false;
  bool spike_ = false;  ///< in the last solution's pressure
  bool widened_ = false;
  ResultTrend trend_;
  double expected_ = 1;   ///< descent of the state set out for, over the last answer's [-]
  WheelsetPose learned_;  ///< pose of the wheel that memory is of
  bool held_ = false;     ///< the wheel is at that pose, but for its height
  double load_ = 0;       ///< of the last usable solution [N]; 0: none
  int solutions_ = 0;
};
}  // namespace wheel_rail_contact::core
