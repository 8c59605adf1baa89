// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "wheel_rail_contact/balance/pressure_extent.h"
#include "wheel_rail_contact/config.h"
#include "wheel_rail_contact/geometry/contact_search.h"
#include "wheel_rail_contact/geometry/gap.h"
#include "wheel_rail_contact/normal/normal_solver.h"

namespace wheel_rail_contact
{
/// Cells of the grid laid over a patch.
struct GridSize
{
  int along = 0;
  int across = 0;
};

/// First touch of rigid bodies, side axes.
struct RigidTouch
{
  bool found = false;      ///< false: the wheel is beside the rail
  double axle_height = 0;  ///< z of the axle centre at which wheel and rail touch, at the pose's y, yaw and roll [m]
  double lever = 0;        ///< -d(axle_height)/d(roll) with the bodies in touch [m]
  InitialContact contact;
};

/// What a wheel's contact does to its rail, side axes.
struct WheelForces
{
  double outward = 0;   ///< on the rail [N]
  double vertical = 0;  ///< on the rail, down [N]
  double moment = 0;    ///< on the rail head about its reference point, outward roll positive [N m]
};

enum class WheelStatus
{
  solved,
  no_contact,     ///< asked height leaves the wheel above the rail, or no load was asked for
  beside_rail,    ///< wheel and rail share no stretch of the track's width
  off_profile,    ///< pressure beyond the end of a profile
  box_not_found,  ///< no grid was found that holds all of the contact
  normal_failed   ///< the normal solution is not usable, see solution().status
};

/// One patch as solved, beside its pressure.
struct WheelPatch
{
  OverlapZone zone;            ///< stretch it was laid over
  double touch_gap = 0;        ///< vertical gap at the first touch of the whole wheel [m]
  double half_overlap = 0;     ///< half-length of the overlap along the track [m]
  double expected_width = 0;   ///< of the pressure, for which the grid was laid [m]
  double expected_length = 0;  ///< likewise, along the track [m]
  ContactPlane plane;
  std::vector<GapColumn> columns;
  PressureExtent extent;
  double slope = 0;     ///< pressure-weighted mean of the common normal's slope against the plane [-]
  double center_x = 0;  ///< pressure's centre in the patch frame [m]
  double center_y = 0;  ///< [m]
};

/// Contact of one wheel with one rail in side axes: finds the stretches that overlap, lays a plane and a grid over
/// each, and solves all of them at one descent of the wheel.
///
/// Remembers, relative to the overlapping stretch, where in it the last contact lay and how its plane was turned.
/// Memory changes only where learn() is called (or a box has cut the contact off): between, the solution is a smooth
/// function of the placement. planeError() and boxFill() tell how well the remembered planes and boxes still fit.
class WheelContact
{
 public:
  /// Refers to `config` and `solver`, which must outlive it.
  WheelContact(const ContactModelConfig& config, NormalSolver& solver);

  void setRail(const PlacedRail& rail);
  const PlacedRail& rail() const { return *rail_; }

  /// First touch at a pose (its z is not used).
  RigidTouch touch(const WheelsetPose& pose);

  /// Estimated descent of the axle below the first touch under a vertical load [m]: from the last solution, or Hertz
  /// with the curvatures that the separation has over the contact's own width.
  double estimateDescent(const RigidTouch& touch, double load) const;

  /// Solves the contact at the pose last given to touch() under a vertical load [N].
  WheelStatus solveLoad(const RigidTouch& touch, double load, const GridSize& size);
  /// The same with the axle `descent` below the first touch [m].
  WheelStatus solveDescent(const RigidTouch& touch, double descent, const GridSize& size);

  /// Takes the last solution over into memory: the next call lays its planes and boxes after it.
  void learn();

  /// Descent of the axle below the first touch in the last solution [m].
  double descent() const { return solution_.approach; }
  WheelForces forces() const;
  /// Height of the forces' mean place over the rail head's reference point [m].
  double heightOverReference() const;
  /// Load-weighted mean angle by which planes are off the pressure-weighted normal [rad].
  double planeError() const;
  /// Smallest ratio of a pressure's length or width to those its grid was laid for [-].
  double boxFill() const { return box_fill_; }
  /// A box of the last call had to be widened for pressure that its first form missed, and may be loose now.
  bool widened() const { return widened_; }
  /// -d(axle height)/d(roll) at constant load [m].
  double lever() const;
  int solutions() const { return solutions_; }

  const std::vector<WheelPatch>& patches() const { return patches_; }
  const NormalProblem& problem() const { return problem_; }
  const NormalSolution& solution() const { return solution_; }

  void reset();

 private:
  /// Where a contact lay in its overlapping stretch.
  struct Memory
  {
    double rail_u = 0;  ///< place of the contact on the rail, to know it again [m]
    double center = 0;  ///< middle of the pressure, in half-widths of the stretch from its middle [-]
    double begin = 0;   ///< edges of the pressure, likewise [-]
    double end = 0;
    double half_length = 0;  ///< of the pressure along the track, in half-lengths of the overlap [-]
    double turn = 0;         ///< plane against the tangent at the initial contact [rad]
    double shift_x = 0;      ///< pressure's centre against the initial contact [m]
    Grid grid;               ///< as laid after this memory; no cells: not laid yet
    double width = 0;        ///< of the pressure as expected when the grid was laid [m]
    double length = 0;       ///< likewise, along the track [m]
  };
  WheelStatus solve(const RigidTouch& touch, const GridSize& size);
  bool layBoxes(const RigidTouch& touch, const GridSize& size);
  Memory& recall(const OverlapZone& zone);
  void layBox(const GridSize& size, WheelPatch& patch, Grid& grid);
  void measure();
  Memory remember(const WheelPatch& patch, const Grid& grid) const;
  static void growCut(const PressureExtent& extent, const Grid& grid, Memory& memory);
  bool missesPressure(const RigidTouch& touch, std::size_t k);
  double displacementBeside(std::size_t k, double t) const;
  bool boxesHold(const RigidTouch& touch);
  bool onProfiles() const;

  const ContactModelConfig& config_;
  NormalSolver& solver_;
  double modulus_;
  ContactSearch search_;
  std::optional<PlacedRail> rail_;
  std::optional<PlacedWheel> wheel_;
  std::vector<OverlapZone> zones_;
  std::vector<Station> stations_;
  std::vector<WheelPatch> patches_;
  std::vector<Memory> memory_;
  NormalProblem problem_;
  NormalSolution solution_;
  double boxed_descent_ = 0;  ///< descent for which the boxes were laid [m]
  double box_fill_ = 1;
  bool box_cut_ = false;
  bool widened_ = false;
  double load_ = 0;  ///< of the last usable solution [N]; 0: none
  int solutions_ = 0;
};
}  // namespace wheel_rail_contact
