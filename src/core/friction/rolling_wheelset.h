// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "core/friction/rolling_contact.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core
{
/// Friction in all contacts of a wheelset whose normal forces are known.
class RollingWheelset
{
 public:
  /// Keeps a reference to `config`, which must outlive this.
  explicit RollingWheelset(const ContactModelConfig& config);

  /// The next free rotation is searched from pure rolling.
  void reset();
  /// Sets the contacts of a balance and solves them at the given or the free rotation.
  /// @return reason of a failure; empty if the forces may be used
  std::string_view solve(const WheelsetState& state, const WheelsetBalance& balance);

  /// Normal force of a wheel [N].
  double normalForce(Side side) const;
  /// Friction on a wheel, track axes.
  Wrench onWheel(Side side) const;
  /// Friction on a rail along its coordinates, with or without its lateral force, see RollingContact.
  Eigen::Vector3d onRail(Side side, bool with_lateral) const;

  /// Number of contacts; left side first.
  std::size_t count() const { return count_; }
  RollingContact& contact(std::size_t index) { return contacts_[index]; }
  /// The contact of a side with the largest normal force; the number of contacts if there is none.
  std::size_t strongest(Side side) const;
  /// Motion over ground of the last solution. With solved height and roll, each contact corrects its vertical velocity,
  /// see RollingContact::solve().
  const WheelsetMotion& motion() const { return motion_; }
  /// Turn of the frame of the given motion [1/m]; zero if it is that over ground.
  const Eigen::Vector3d& frameTurn() const { return frame_turn_; }
  double speed() const { return speed_; }

  /// Adds friction to a result, whose patches have their pose and the forces by the pressure.
  void addTo(const WheelsetBalance& balance, WheelsetResult& result) const;

 private:
  void setContacts(const WheelsetState& state, const WheelsetBalance& balance);
  RollingContact& nextContact(Side side);
  void setMotion(const WheelsetState& state, const WheelsetBalance& balance);
  double momentAbout(const Eigen::Vector3d& axle, double rotation);
  bool rollFreely(const Eigen::Vector3d& axle);
  bool followSecants(const Eigen::Vector3d& axle, double start, double accuracy);
  /// Sum of a quantity of the contacts of a side.
  template <typename Quantity, typename Get>
  Quantity sumOf(Side side, Quantity sum, const Get& get) const;

  const ContactModelConfig& config_;
  Sides<ShearElasticity> elasticity_;
  WheelsetMotion motion_;                           ///< over ground
  Eigen::Vector3d turn_ = Eigen::Vector3d::Zero();  ///< of the track frame, see turnOf()
  Eigen::Vector3d frame_turn_ = Eigen::Vector3d::Zero();
  double speed_ = 0, frame_rotation_ = 0;  ///< along the track [m/s]; of the frame about y, in motion_ [rad/s]
  std::vector<RollingContact> contacts_;   ///< only the first ones are contacts of the balance; left side first
  std::size_t count_ = 0;
  std::vector<std::size_t> contact_of_;  ///< contact of each patch of the result
  std::vector<CreepStatus> statuses_;
  double free_rotation_;   ///< last one over the speed [1/m]
  double free_slope_ = 0;  ///< change of the moment about the axle by the rotation, times |V| [N m^2]; 0: unknown
};
}  // namespace wheel_rail_contact::core
