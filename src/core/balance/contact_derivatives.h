// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "core/balance/wheelset_balance.h"
#include "core/normal/solvers/contact_tangent.h"
#include "wheel_rail_contact/core/sides.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Change of the normal contact of one wheel by movements of the axle, in side axes.
///
/// The geometry is a difference: the gap is built again, on the same cells, for an axle moved by little. The change of
/// the pressure is that of the linear problem, in which the cells under pressure remain (ContactTangent): the change of
/// the contact area has an effect of second order only.
class MovedContact
{
 public:
  /// Movements of the axle: outward, up [m], roll, yaw [rad].
  static constexpr int movements = 4;
  using Movements = Eigen::Matrix<double, 6, movements>;

  /// Finds the changes of a wheel that is solved.
  /// @param axle  pose of the axle, side axes
  void find(const ContactModelConfig& config, Side side, const WheelContact& contact, const Islands& islands,
            const WheelsetPose& axle);

  /// Force [N] and moment about the axle centre [N m] of the rail on the wheel.
  const Eigen::Matrix<double, 6, 1>& wrench() const { return wrench_; }
  /// Change of the wrench by movements of the axle, with the rail held.
  const Movements& held() const { return held_; }
  /// The same, with the deflection of the rail; not a number where the deflection is not stable.
  Movements onBendingRail(const WheelEquilibrium& wheel, const WheelsetPose& axle, bool own_force) const;

 private:
  struct Cells
  {
    std::vector<PatchGap> patches;
    std::vector<std::vector<SurfaceColumn>> columns;
    std::vector<double> x;  ///< place of the middle of each grid along the track [m]
  };

  void build(const WheelsetPose& axle, Cells& cells);
  PlacedWheel wheelAt(const WheelsetPose& axle) const;
  Eigen::Matrix<double, 6, 1> wrenchOf(const Cells& cells, const WheelsetPose& axle, double step,
                                       const std::vector<Eigen::ArrayXXd>& change) const;
  void findColumns(std::size_t first, std::size_t end, const CurvedProblem& problem, const NormalSolution& solution,
                   const WheelsetPose& axle);
  void unfold();

  const ContactModelConfig* config_ = nullptr;  ///< of the last call of find(), as the next three
  Side side_ = Side::left;
  const WheelContact* contact_ = nullptr;
  const std::vector<Island>* islands_ = nullptr;
  const CurvedProblem* problem_ = nullptr;
  const NormalSolution* solution_ = nullptr;
  CurvedProblem whole_problem_;  ///< of a symmetric one
  NormalSolution whole_solution_;
  ContactTangent tangent_;
  std::array<Cells, movements> ahead_, behind_;  ///< moved forward and back
  Eigen::ArrayXXd slope_;
  std::vector<std::vector<Eigen::ArrayXXd>> openings_, changes_;  ///< of each movement and patch
  Eigen::Matrix<double, 6, 1> wrench_ = Eigen::Matrix<double, 6, 1>::Zero();
  Movements held_ = Movements::Zero();
};

/// Derivatives of the contact of a wheelset, see ContactDerivatives.
class WheelsetDerivatives
{
 public:
  /// Keeps a reference to `config`, which must outlive this.
  explicit WheelsetDerivatives(const ContactModelConfig& config) : config_(config) {}

  /// Finds the derivatives of a usable result. @return why they do not exist; otherwise empty
  std::string_view find(const WheelsetBalance& balance, ContactDerivatives& out);
  /// Sets all derivatives to NaN. @return the reason
  std::string_view missing(std::string_view reason, ContactDerivatives& out) const;

 private:
  using Movements = MovedContact::Movements;

  bool solve(const WheelsetBalance& balance, ContactDerivatives& out) const;
  Eigen::Matrix<double, 1, MovedContact::movements> touchRow(const WheelsetBalance& balance, Side side) const;

  const ContactModelConfig& config_;
  Sides<MovedContact> contacts_;
  Sides<Movements> wheels_;  ///< of each wheel, track axes, with the deflection of its rail
};
}  // namespace wheel_rail_contact::core
