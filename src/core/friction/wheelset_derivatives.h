// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "core/friction/moved_friction.h"

namespace wheel_rail_contact::core
{
/// Derivatives of the contact of a wheelset, see ContactDerivatives.
///
/// The changes of each wheel are those by its movement on its rail and by the motion. The forces bend the rails, which
/// moves the wheels on them, and a free rotation changes: both follow from linear equations.
class WheelsetDerivatives
{
 public:
  /// Keeps a reference to `config`, which must outlive this.
  explicit WheelsetDerivatives(const ContactModelConfig& config) : config_(config), friction_(config) {}

  /// Finds the derivatives of a usable result.
  /// @param rolling  its friction; null: none
  /// @param out      after clear(); those that do not exist remain
  /// @return why they do not exist; otherwise empty
  std::string_view find(const WheelsetBalance& balance, RollingWheelset* rolling, ContactDerivatives& out);
  /// Sets all derivatives to NaN.
  void clear(ContactDerivatives& out) const;

 private:
  static constexpr int known = ContactDerivatives::positions + ContactDerivatives::force_motions;
  /// Inputs of MovedFriction, and an outward roll of each wheel with its rail.
  static constexpr int inputs = MovedFriction::inputs + 2;
  using Wheel = Eigen::Matrix<double, 6, known>;
  using Wrench = Eigen::Matrix<double, 6, inputs>;
  using Equations = Eigen::Matrix<double, 7, inputs>;

  std::string_view fault(const WheelsetBalance& balance, const RollingWheelset* rolling) const;
  bool hasCreep() const { return config_.creep.method != CreepMethod::none; }
  bool isFree() const { return config_.creep.rotation == CreepConfig::Rotation::free; }
  bool findForces(const WheelsetBalance& balance, const RollingWheelset* rolling, bool follows);
  void addWheel(Side side, const RollingWheelset* rolling, bool follows, Wrench& wrench, Equations& equations) const;
  static void addMotion(const WheelsetPose& axle, const RollingWheelset& rolling,
                        Eigen::Ref<Eigen::Matrix<double, 6, known>> motion);
  bool findSolution(ContactDerivatives& out) const;

  const ContactModelConfig& config_;
  Sides<MovedContact> contacts_;
  MovedFriction friction_;
  Sides<Wheel> wheels_;  ///< wrench on each wheel by the columns of ContactDerivatives::forces
};
}  // namespace wheel_rail_contact::core
