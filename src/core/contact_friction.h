// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/track/placement.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Friction in the patches of a wheelset, and what it adds to the balance of its normal forces.
class ContactFriction
{
 public:
  /// Keeps a reference to `config`, which must outlive this.
  explicit ContactFriction(const ContactModelConfig& config);

  /// True if a method is set.
  bool isSet() const { return config_.creep.method != CreepMethod::none; }
  /// True if there are creep forces at this speed.
  bool acts(const WheelsetState& state) const;
  /// The next balance begins without friction.
  void reset();
  /// Begins the passes for a state, with the friction of the last result.
  void begin()
  {
    passes_ = 0;
    best_change_ = std::numeric_limits<double>::infinity();
  }
  /// The next balance has the friction of the pass with the least change, once. @return false if it is above `limit`
  bool returnToBest(double limit);
  /// Ends the passes, of which there was one: the next state begins with the friction that was found last.
  void end() { assumed_ = found_[place(passes_ - 1)]; }
  /// True if the next balance begins with friction.
  bool isAssumed() const { return !assumed_.isZero(0); }
  /// Loads that the normal forces alone balance: those of the state with the friction on the wheels.
  WheelsetState withFriction(WheelsetState state) const;
  /// Friction on a rail along its coordinates (core/balance/rail_support.h) [N], [N], [N m].
  Eigen::Vector3d onRail(Side side) const { return ofSide(side).tail<3>(); }

  /// Fills the creep forces of the patches of a result whose normal forces are known, and adds them to the wheels and
  /// to the wrench of the rails.
  /// The next balance begins with an extrapolation of the passes (Anderson 1965, J. ACM 12): where a wheel slides on
  /// its flange, friction carries nearly the whole load, and the forces of successive passes alternate.
  /// @param heads  reference points of the rails, side axes
  /// @return reason of a failure; empty if the forces may be used
  std::string_view fill(const WheelsetState& state, const Sides<PlanePoint>& heads, WheelsetResult& result);
  /// Largest difference of the friction on a rail from that of the balance, over the normal force of its wheel [-].
  double change() const { return change_; }

 private:
  /// Friction on each wheel and rail: upward force on the wheel [N], its moment about the axle centre about x of the
  /// track [N m], and onRail(); of the left side, then of the right one.
  static constexpr int of_side = 5, depth = 3;
  using Friction = Eigen::Matrix<double, 2 * of_side, 1>;
  /// A patch and its forces.
  struct Contact
  {
    CreepProblem problem;
    ContactPlace place;
    CreepSolution solution;
  };

  /// Place of a pass in found_ and open_.
  static std::size_t place(int pass) { return static_cast<std::size_t>(pass % (depth + 1)); }
  void setContacts(const WheelsetState& state, const Sides<PlanePoint>& heads, WheelsetResult& result);
  double momentAbout(const Eigen::Vector3d& axle, double rotation);
  bool rollFreely(const Eigen::Vector3d& axle);
  void addForces(PatchResult& patch, const Contact& contact, const PlanePoint& head, WheelsetResult& result,
                 Friction& found) const;
  Eigen::Matrix<double, of_side, 1> ofSide(Side side) const
  {
    return assumed_.segment<of_side>(of_side * static_cast<int>(side));
  }
  Friction extrapolated(const Friction& found);
  double changeTo(const Friction& found, const Sides<WheelForces>& wheels) const;

  const ContactModelConfig& config_;
  std::unique_ptr<CreepSolver> solver_;
  Sides<ShearElasticity> elasticity_;
  WheelsetMotion motion_;
  std::vector<Contact> contacts_;  ///< only the first ones belong to the result
  std::size_t count_ = 0;
  double free_rotation_;                          ///< last one over the speed [1/m]
  Friction assumed_ = Friction::Zero();           ///< of the next balance
  std::array<Friction, depth + 1> found_, open_;  ///< of the last passes; difference from the one assumed
  Friction best_ = Friction::Zero();              ///< assumed in the pass with the least change
  int passes_ = 0;
  double change_ = 0, best_change_ = 0;
};
}  // namespace wheel_rail_contact::core
