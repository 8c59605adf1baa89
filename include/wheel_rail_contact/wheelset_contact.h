// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "wheel_rail_contact/balance/wheelset_state.h"
#include "wheel_rail_contact/config.h"
#include "wheel_rail_contact/normal/problem.h"
#include "wheel_rail_contact/rail/compliance.h"

namespace wheel_rail_contact
{
/// Pose of a patch frame: origin at the reference point on the rail, x forward, y left in the tangent plane, z the
/// common normal out of the rail. The frame is turned about x only.
struct PatchPose
{
  double x = 0, y = 0, z = 0;  ///< [m], track frame
  double angle = 0;            ///< rotation about x [rad]
};

/// One contact patch of an answer.
struct PatchResult
{
  Side side = Side::left;       ///< of the wheel
  std::string_view method;      ///< that solved it, named as in `contact/method`
  PatchPose pose;               ///< of the patch frame
  double contact_angle = 0;     ///< >= 0 [rad]
  double normal_force = 0;      ///< [N]
  double approach = 0;          ///< along the patch's normal [m]
  double area = 0;              ///< [m²]
  double max_pressure = 0;      ///< highest, between the cells; may be below the highest cell [Pa]
  double error_estimate = 0;    ///< relative [-]
  int iterations = 0;           ///< products with the influence matrix
  double residual = 0;          ///< violation of the contact conditions over the approach [-]
  double half_space_ratio = 0;  ///< half the angle through which wheel or rail turns over the patch [rad]
  Grid grid;                    ///< never symmetric here: the whole patch, in the patch frame
  Eigen::ArrayXXd pressure;     ///< nx × ny [Pa]
};

/// The answer to one state.
struct WheelsetResult
{
  ContactStatus status = ContactStatus::invalid_input;  ///< whether the rest may be used
  std::string reason;                                   ///< one sentence, empty when ok and within the tolerance
  bool above_tolerance = false;                         ///< a patch's error estimate is above contact/tolerance
  double y = 0, z = 0, yaw = 0, roll = 0;               ///< axle centre [m, rad], with the solved height and roll
  std::array<RailResult, 2> rail;                       ///< by Side
  std::vector<PatchResult> patches;                     ///< empty unless usable
};

/// The whole chain: pose and load -> placement -> search -> gap -> normal solution -> balance.
///
/// Keeps the last answer as a starting point; not thread-safe, one object per wheelset.
class WheelsetContact
{
 public:
  /// @throw std::invalid_argument naming the option, its value and the broken rule.
  explicit WheelsetContact(ContactModelConfig config);
  ~WheelsetContact();
  WheelsetContact(WheelsetContact&&) noexcept;
  WheelsetContact& operator=(WheelsetContact&&) noexcept;

  /// Answers one state. Never throws for bad states or numerical failure: the status tells.
  const WheelsetResult& evaluate(const WheelsetState& state);

  /// Forgets the last answer: the next evaluation starts cold.
  void reset();

  /// As given when it was made.
  const ContactModelConfig& config() const;

 private:
  class Chain;
  std::unique_ptr<Chain> chain_;
};
}  // namespace wheel_rail_contact
