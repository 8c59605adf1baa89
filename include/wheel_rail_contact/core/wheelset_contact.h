// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>

#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Computes the contact of one wheelset with both rails, from pose and load to the pressure in each contact patch.
///
/// The steps are placement, contact search, gap, normal solution and vertical balance (see doc/theory.md). An example
/// is in doc/library.md.
///
/// Each evaluation starts from the previous result (warm start). This saves time and changes the result only within the
/// tolerance. Not thread-safe: use one object per wheelset.
class WheelsetContact
{
 public:
  /// Checks the parameters (validate()), places the rails and prepares the solvers.
  /// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
  explicit WheelsetContact(ContactModelConfig config);
  ~WheelsetContact();
  WheelsetContact(WheelsetContact&&) noexcept;
  WheelsetContact& operator=(WheelsetContact&&) noexcept;

  /// Evaluates one state. Does not throw for an invalid state or a numerical failure: check WheelsetResult::status.
  /// @return the result. The reference is valid until the next call, at most for the life of the object.
  const WheelsetResult& evaluate(const WheelsetState& state);

  /// Stiffness of the contact of one wheel in the last result, with the rail held: how the forces of the rail on the
  /// wheelset fall per unit of a movement of the axle. Takes about 20 products with the influence matrix.
  /// @return 3 × 3, symmetric, for the lateral position [m], the height [m] and the roll [rad] of the axle in the track
  ///         frame, and the forces [N] and the moment about the axle centre [N m] along them; zero if the wheel carries
  ///         no load or the last result is not usable. It contains the change of the contact's position and normal with
  ///         the movement.
  Eigen::Matrix3d stiffness(Side side);

  /// Discards the previous result: the next evaluation starts cold.
  void reset();

  /// The parameters given to the constructor.
  const ContactModelConfig& config() const;

 private:
  class Calculation;
  std::unique_ptr<Calculation> calculation_;
};
}  // namespace wheel_rail_contact::core
