// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/balance/moved_contact.h"
#include "core/balance/wheelset_balance.h"
#include "core/creep/creep_strips.h"
#include "wheel_rail_contact/core/creep.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Friction on the pressure of one grid of a wheel. Each column rolls at its own place along its own tangent plane.
/// Nothing jumps where two islands join. Track axes.
///
/// CreepMethod::linear knows no columns, but ellipses: those on both sides of the column whose force is w times the
/// smaller of the largest ones on either side, with the weight 1 - w, and their common ellipse with the weight w. The
/// weights are our own.
class RollingContact
{
 public:
  explicit RollingContact(CreepMethod method) : solver_(makeCreepSolver(method)) {}

  /// Sets elasticity and friction.
  void setMaterial(const ShearElasticity& elasticity, const FrictionLaw& friction);
  /// Sets all columns of a grid of a wheel, and direction and velocity of its rail.
  void place(Side side, const WheelsetBalance& balance, std::size_t grid, const RailMotion& direction,
             const RailRates& velocity);
  /// Sets all columns again after little has moved, for a difference. A contact that was joined is joined again.
  void placeMoved(const PressedGrid& grid);
  /// Replaces the columns by the centres of pressure of ellipses.
  void join();

  /// Solves the contact at a motion. The last tractions are the start.
  /// @param follows  the wheel follows the rail: the vertical velocity of the motion is replaced by the one at which
  ///                 the particles have no velocity along the normal at the centre of pressure
  CreepStatus solve(WheelsetMotion motion, bool follows);
  /// The next solution starts cold.
  void forget();

  Side side() const { return side_; }
  std::size_t grid() const { return grid_; }
  /// Motion of the last solution.
  const WheelsetMotion& motion() const { return motion_; }
  /// Sum over the columns [N].
  double normalForce() const { return whole_.load; }
  /// The contact at its centre of pressure.
  const ContactPlace& centre() const { return whole_.place; }
  /// Friction on the wheelset.
  Wrench onWheelset() const { return onWheelset(0, columns_.size()); }
  /// Friction on the rail along its coordinates (core/balance/rail_support.h), side axes [N], [N], [N m].
  /// @param with_lateral  false: a given lateral force replaces that of the contact
  Eigen::Vector3d onRail(bool with_lateral) const;
  /// Adds the friction of an island to its result, which has its pose and the forces by the pressure.
  void addTo(const Island& island, bool with_field, PatchResult& patch) const;

 private:
  struct Column
  {
    ContactPlace place;                                 ///< its middle, on the undeformed wheel
    Eigen::Vector3d on_rail = Eigen::Vector3d::Zero();  ///< the same on the rail, from the axle centre [m]
    double load = 0;                                    ///< normal force [N]
    double overlap = 0;                                 ///< of the undeformed bodies [m]
    double centre_x = 0;                                ///< its centre of pressure, from the middle [m]
    Eigen::Matrix3d axes;                               ///< patchAxes() of its place
    // Of an ellipse that replaces columns:
    std::size_t highest = 0;  ///< the one with the largest force
    double weight = 1;
    CreepForce force;                                  ///< with the weight
    double semi_axis_along = 0, semi_axis_across = 0;  ///< [m]
  };

  std::size_t indexOf(Eigen::Index side_column) const;
  void join(const CreepStrips::Ellipse& per_strips);
  void addEllipses(double first, double end, double weight);
  CreepStatus solveEllipses();
  void placeColumns(const PressedGrid& grid);
  void setRail();
  Column meanOf(double first, double end) const;
  const CreepForce& forceOf(std::size_t column) const
  {
    return is_joined_                  ? columns_[column].force
           : solution_.columns.empty() ? solution_.force
                                       : solution_.columns[column];
  }
  Wrench onWheelset(std::size_t first, std::size_t end) const;

  Side side_ = Side::left;
  std::size_t grid_ = 0;
  RailMotion direction_;
  RailRates velocity_;
  std::unique_ptr<CreepSolver> solver_;
  bool is_new_ = true;  ///< not solved since place()
  CreepProblem problem_;
  CreepSolution solution_;
  WheelsetMotion motion_;        ///< of the solution
  std::vector<Column> columns_;  ///< from the right to the left, or ellipses
  std::vector<Column> ellipses_;
  bool is_joined_ = false;           ///< the columns are ellipses
  CreepStrips::Ellipse per_strips_;  ///< area and ratio of the whole ellipse over those of its strips
  Column whole_;                     ///< all columns as one
  CreepStrips strips_;
  Eigen::Vector3d head_ = Eigen::Vector3d::Zero();  ///< reference point of the rail, from the axle centre [m]
};
}  // namespace wheel_rail_contact::core
