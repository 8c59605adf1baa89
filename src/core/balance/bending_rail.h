// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/balance/fixed_point.h"
#include "core/balance/rail_step.h"
#include "core/balance/wheel_contact.h"
#include "wheel_rail_contact/core/wheelset_result.h"
#include "wheel_rail_contact/core/wheelset_state.h"

namespace wheel_rail_contact::core
{
/// The rail under one wheel: its position and its deflection by the forces of the contact. Side axes.
///
/// There are three modes:
/// - held: no deflection, or a prescribed one.
/// - solved: the rail bends under the contact's own forces, and the normal method can solve a compliant support. The
///   deflection is then part of each normal solution. The rail is set again to the deflection of the previous pass
///   until its displacement along the contact plane, which the gap contains only to first order, is small enough.
/// - mixed: other methods, and given lateral forces. Anderson mixing brings the deflection used and the deflection that
///   the forces cause together.
class BendingRail
{
 public:
  /// Keeps references to `config` and `wheel`, which must outlive this. `solved_with_contact`: the method of the wheel
  /// solves compliant supports.
  BendingRail(const ContactModelConfig& config, bool solved_with_contact, WheelContact& wheel);

  /// Returns to the undeflected position, or to the prescribed deflection.
  void reset();

  /// Prepares another state: from a cold start, or from the last result in proportion to the load.
  /// @param load    load of the wheel, known or expected [N]
  /// @param offset  deflection caused by other forces than those of this wheel
  void begin(bool cold, double load, const RailDeflection& offset);

  /// Cold start only. If the flange touches first and would lift the wheel, moves the rail outward until the tread
  /// touches first, provided that the load can bend the rail that far. The flange then comes into contact next to the
  /// tread.
  /// @param touch  first touch of the wheel at the pose, with the rail in its present position
  /// @return the first touch with the rail in its new position
  RigidTouch clearFlange(const RigidTouch& touch, const WheelsetPose& pose, double load);

  /// First touch on the rail under the given forces only. Does not change the position of the rail.
  /// @param given_lateral  outward force, for LateralForce::topic [N]
  RigidTouch touchAtRest(const WheelsetPose& pose, double given_lateral, const RailDeflection& offset);

  /// Distance by which the wheel moves down with its rail per unit load, for the force direction of the last solution
  /// [m/N].
  double deflectionPerLoad() const;
  /// Same for a force along the common normal of a first touch, without its moment [m/N].
  double deflectionPerLoad(const RigidTouch& touch) const;
  /// Distance by which the wheel would move down, in addition to WheelContact::penetration(), if the rail were set to
  /// the deflection that the forces of the last solution cause [m].
  double remainingDeflection() const { return remaining_deflection_; }

  /// Takes the forces of the wheel's last solution and moves the rail towards the deflection that they cause.
  /// @param given_lateral  outward force, for LateralForce::topic [N]
  /// @return remaining difference over the allowed one; converged if at most 1
  double follow(bool loaded, double given_lateral);

  /// Accepts the last solution as the result.
  void finish(bool loaded);

  /// Present deflection and forces.
  const RailResult& result() const { return result_; }

 private:
  enum class Mode
  {
    held,    ///< no bending, or prescribed
    mixed,   ///< deflection used and deflection caused by the forces are mixed
    solved,  ///< deflection solved together with the contact
  };

  Eigen::Vector3d underLoad(double load) const;
  void set(const Eigen::Vector3d& own);
  double setStraight();
  void moveTo(const Eigen::Vector3d& own);
  double lateralForce(double of_contact, double given) const;
  RailForce takeForce(bool loaded, double given_lateral);
  double slipRatio() const;
  double followContact(bool loaded);
  double mix(const RailForce& force);

  const ContactModelConfig& config_;
  WheelContact& wheel_;
  Mode mode_ = Mode::held;
  PlacedRail undeflected_;
  Eigen::Matrix3d compliance_;
  Eigen::Vector3d offset_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d placed_ = Eigen::Vector3d::Zero();  ///< own deflection to which the rail is set
  Eigen::Vector3d own_ = Eigen::Vector3d::Zero();     ///< own deflection of the last result
  bool loaded_ = false;                               ///< the wheel carried load in the last result
  double remaining_deflection_ = 0;                   ///< see remainingDeflection() [m]
  FixedPoint<3> mixing_;
  RailStep step_;
  RailResult result_;
};
}  // namespace wheel_rail_contact::core
