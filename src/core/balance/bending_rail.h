// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/balance/fixed_point.h"
#include "core/balance/rail_step.h"
#include "core/balance/wheel_contact.h"
#include "wheel_rail_contact/core/wheelset_result.h"
#include "wheel_rail_contact/core/wheelset_state.h"

namespace wheel_rail_contact::core
{
/// The rail under one wheel: where it is set, and how it follows the contact's forces. Side axes.
///
/// Where the contact's own forces bend it and the normal method can solve a support that yields, the deflection comes
/// out of each normal solution, at a rail set to what the pass before found; it is set anew until what the gap knows to
/// first order only, the rail's way along the contact plane, is short enough. Where the forces would change the contact
/// by less than a part of the tolerance, the rail's own deflection is left out of the gap. Other methods, and lateral
/// forces that are given, bring deflections due and used together by Anderson's mixing.
class BendingRail
{
 public:
  /// Refers to `config` and `wheel`, which must outlive it. `solved_with_contact`: the wheel's method solves supports.
  BendingRail(const ContactModelConfig& config, bool solved_with_contact, WheelContact& wheel);

  /// Back to where no force bends it, or to the deflection prescribed.
  void reset();

  /// Sets out for another state: from cold, or from the last answer in proportion to the load.
  /// @param load    of the wheel, known or expected [N]
  /// @param offset  deflection that other forces than the wheel's cause
  void begin(bool cold, double load, const RailDeflection& offset);

  /// From cold: where the rail would lift the wheel by its flange, sets it out until the wheel's tread comes down on
  /// it, if the load can bend the rail so far; the flange then comes into contact beside the tread.
  /// @param touch  of the wheel at the pose, with the rail as it is set
  /// @return the first touch with the rail as it then is set
  RigidTouch letFlangeDown(const RigidTouch& touch, const WheelsetPose& pose, double load);

  /// First touch on the rail as it lies with nothing but given forces on it. Leaves the rail where it is set.
  /// @param given_lateral  outward force, for LateralForce::topic [N]
  RigidTouch touchAtRest(const WheelsetPose& pose, double given_lateral, const RailDeflection& offset);

  /// How far the wheel comes down with its rail under a newton more, the direction of the force being that of the last
  /// solution's [m/N].
  double deflectionPerLoad() const;
  /// The same for a force along the common normal of a first touch, without its moment [m/N].
  double deflectionPerLoad(const RigidTouch& touch) const;
  /// How far the wheel would come down if the rail were set where the last solution's forces want it, beyond what
  /// WheelContact::descent() counts [m].
  double remainingDeflection() const { return remaining_deflection_; }

  /// Takes over the forces of the wheel's last solution, and moves the rail to where they want it.
  /// @param given_lateral  outward force, for LateralForce::topic [N]
  /// @return how far it still is from there: settled up to 1
  double follow(bool loaded, double given_lateral);

  /// The answer stands.
  void finish(bool loaded);

  /// Deflection and forces as they stand.
  const RailResult& result() const { return result_; }

 private:
  enum class Mode
  {
    held,    ///< no bending, or prescribed
    mixed,   ///< deflections due and used brought together
    solved,  ///< with the contact
  };

  Eigen::Vector3d underLoad(double load) const;
  void set(const Eigen::Vector3d& own);
  double setStraight();
  void moveTo(const Eigen::Vector3d& own);
  double lateralForce(double of_contact, double given) const;
  RailForce takeForce(bool loaded, double given_lateral);
  double slipOver() const;
  double effectLimit() const;
  double followContact(bool loaded);
  double mix(const RailForce& force);

  const ContactModelConfig& config_;
  WheelContact& wheel_;
  Mode mode_ = Mode::held;
  PlacedRail undeflected_;
  Eigen::Matrix3d compliance_;
  Eigen::Vector3d offset_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d placed_ = Eigen::Vector3d::Zero();  ///< own deflection it is set to
  Eigen::Vector3d own_ = Eigen::Vector3d::Zero();     ///< own deflection of the last answer
  bool straight_ = false;                             ///< own deflection left out of the gap
  bool straighten_ = false;                           ///< from the next state on
  bool loaded_ = false;                               ///< in the last answer
  double remaining_deflection_ = 0;                   ///< see remainingDeflection() [m]
  FixedPoint<3> mixing_;
  RailStep step_;
  RailResult result_;
};
}  // namespace wheel_rail_contact::core
