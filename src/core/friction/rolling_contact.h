// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/balance/wheelset_balance.h"
#include "wheel_rail_contact/core/creep.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Friction on the pressure of one grid of a wheel, or of one of its islands with CreepMethod::linear, which knows no
/// columns. Each column rolls at its own place along its own tangent plane. Nothing jumps where two islands join. Track
/// axes.
class RollingContact
{
 public:
  /// Sets elasticity and friction.
  void setMaterial(const ShearElasticity& elasticity, const FrictionLaw& friction);
  /// Sets all columns of a grid of a wheel, and direction and velocity of its rail.
  void place(Side side, const WheelsetBalance& balance, std::size_t grid, const RailRates& slope,
             const RailRates& velocity);
  /// Replaces the columns by one at the centre of pressure of an island.
  void join(const Island& island, const SemiAxes& ellipse);

  /// Solves the contact at a motion. The last tractions are the start.
  /// @param follows  the wheel follows the rail: the vertical velocity of the motion is replaced by the one at which
  /// the
  ///                 particles have no velocity along the normal at the centre of pressure
  CreepStatus solve(WheelsetMotion motion, bool follows, CreepSolver& solver);
  /// The next solution starts cold.
  void forget();

  Side side() const { return side_; }
  /// Sum over the columns [N].
  double normalForce() const { return problem_.normal_force; }
  /// The contact at its centre of pressure.
  ContactPlace centre() const { return meanOf(0, columns_.size()).place; }
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
  };

  std::size_t firstOf(const Island& island) const;
  void placeColumns(const WheelsetBalance& balance, std::size_t grid);
  void setRail(const RailRates& slope, const RailRates& velocity);
  Column meanOf(std::size_t first, std::size_t end) const;
  const CreepForce& forceOf(std::size_t column) const
  {
    return solution_.columns.empty() ? solution_.force : solution_.columns[column];
  }
  Wrench onWheelset(std::size_t first, std::size_t end) const;

  Side side_ = Side::left;
  CreepProblem problem_;
  CreepSolution solution_;
  WheelsetMotion motion_;                           ///< of the solution
  std::vector<Column> columns_;                     ///< from the right to the left, as those of the problem
  Eigen::Vector3d head_ = Eigen::Vector3d::Zero();  ///< reference point of the rail, from the axle centre [m]
};
}  // namespace wheel_rail_contact::core
