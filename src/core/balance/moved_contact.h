// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/balance/wheel_equilibrium.h"
#include "core/normal/estimate/islands.h"
#include "core/normal/solvers/contact_tangent.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
/// Pressure on a grid of a wheel, side axes unless stated otherwise.
struct PressedGrid
{
  const PatchGap& gap;
  const Eigen::ArrayXXd& pressure;  ///< of the same shape [Pa]
  const std::vector<SurfaceColumn>& columns;
  double x;                                ///< of the middle of the grid [m]
  WheelsetPose axle;                       ///< track axes
  PlanePoint head;                         ///< reference point of the rail
  double approach = 0;                     ///< of the bodies from the height of the gap [m]
  const ColumnNormals* normals = nullptr;  ///< of the columns; null: none
};

/// Change of the normal contact of one wheel by movements of the axle.
///
/// The geometry is a difference: the gap is built again, on the same cells, for an axle moved by little. The change of
/// the pressure is that of the linear problem, in which the cells under pressure remain (ContactTangent): the change of
/// the contact area has an effect of second order only.
class MovedContact
{
 public:
  /// Movements of the axle: outward, up [m], roll about the reference point of the rail, yaw [rad], side axes. The
  /// contact hardly notices such a roll, but one about the axle centre: the difference to a rise would be lost.
  static constexpr int movements = 4;
  /// Force on the wheel [N] and moment about the axle centre [N m], track axes; force on the rail along its coordinates
  /// (core/balance/rail_support.h).
  static constexpr int outputs = 9, first_on_rail = 6;
  using Outputs = Eigen::Matrix<double, outputs, 1>;
  using Changes = Eigen::Matrix<double, outputs, movements>;

  /// Finds the changes of a wheel that is solved.
  /// @param axle  pose of the axle, track axes
  void find(const ContactModelConfig& config, Side side, const WheelContact& contact, const Islands& islands,
            const WheelsetPose& axle);

  const Outputs& values() const { return values_; }
  /// Changes by each movement, on a rail that is held.
  const Changes& changes() const { return changes_; }
  /// Movements by y, z, roll and yaw of the axle centre, track axes.
  Eigen::Matrix<double, movements, movements> byAxle() const;
  /// Movements by those of the rail along its coordinates, seen from axes that roll with it.
  static Eigen::Matrix<double, movements, 3> byRail();

  /// Step of a movement for differences of what depends on the pressure of each cell [m], [rad].
  static double stepOf(int movement);
  /// Pose of the axle after a step of a movement, track axes.
  WheelsetPose moved(int movement, double step) const;
  /// A grid after stepOf(), with the sign of `direction`. Valid until the next call.
  PressedGrid pressed(int movement, int direction, std::size_t patch);

 private:
  struct Cells
  {
    std::vector<PatchGap> patches;
    std::vector<std::vector<SurfaceColumn>> columns;
    std::vector<double> x;  ///< place of the middle of each grid along the track [m]
  };

  void build(const WheelsetPose& axle, Cells& cells);
  Outputs sum(int movement, int direction) const;
  void unfold();

  const ContactModelConfig* config_ = nullptr;  ///< of the last call of find(), as the next six
  Side side_ = Side::left;
  const WheelContact* contact_ = nullptr;
  const std::vector<Island>* islands_ = nullptr;
  WheelsetPose axle_;  ///< side axes
  const CurvedProblem* problem_ = nullptr;
  const NormalSolution* solution_ = nullptr;
  CurvedProblem whole_problem_;  ///< of a symmetric one
  NormalSolution whole_solution_;
  ContactTangent tangent_;
  std::array<std::array<Cells, 2>, movements> cells_;               ///< moved back and forward
  std::vector<std::vector<Eigen::ArrayXXd>> openings_, pressures_;  ///< per movement, of each movement and patch
  Eigen::ArrayXXd slope_;
  Eigen::ArrayXXd pressure_;  ///< of pressed(), as the next two
  PatchGap gap_;
  std::vector<SurfaceColumn> columns_;
  Outputs values_ = Outputs::Zero();
  Changes changes_ = Changes::Zero();
};

/// Change of the outputs by a roll of axle and rail about the reference point of the rail, outward positive.
MovedContact::Outputs rolledOutward(Side side, const MovedContact::Outputs& forces);
}  // namespace wheel_rail_contact::core
