// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "wheel_rail_contact/config.h"
#include "wheel_rail_contact/normal/problem.h"
#include "wheel_rail_contact/rail/compliance.h"

namespace wheel_rail_contact
{
/// What is known of a wheelset at one instant; track frame (x forward, y left, z up).
struct WheelsetState
{
  double y = 0;                                ///< axle centre, to the left [m]
  double z = 0;                                ///< axle centre, up [m]; used only if height and roll are given
  double yaw = 0;                              ///< about z [rad]
  double roll = 0;                             ///< about x [rad]; used only if height and roll are given
  double force_z = 0;                          ///< vehicle's force on the axle centre, up [N]; negative presses down
  double torque_x = 0;                         ///< vehicle's moment on the axle centre about x [N m]
  std::array<double, 2> rail_lateral_force{};  ///< outward force on the rail by Side [N], for LateralForce::topic
};

enum class ContactStatus
{
  ok,             ///< every loaded wheel in contact, usable
  lift_off,       ///< at least one wheel carries nothing, the rest is solved; usable
  off_profile,    ///< contact would lie beyond the end of a profile
  not_converged,  ///< normal solution, balance or coupling did not converge
  invalid_input   ///< NaN or infinite input, or angles out of range
};

/// Pose of a patch frame: origin at the reference point on the rail, x forward, y left in the tangent plane, z the
/// common normal out of the rail. The frame is turned about x only.
struct PatchPose
{
  double x = 0, y = 0, z = 0;  ///< [m], track frame
  double angle = 0;            ///< rotation about x [rad]
};

struct PatchResult
{
  Side side = Side::left;
  std::string_view method;
  PatchPose pose;
  double contact_angle = 0;   ///< >= 0 [rad]
  double normal_force = 0;    ///< [N]
  double approach = 0;        ///< along the patch's normal [m]
  double area = 0;            ///< [m²]
  double max_pressure = 0;    ///< [Pa]
  double error_estimate = 0;  ///< relative [-]
  int iterations = 0;
  double residual = 0;
  Grid grid;                 ///< never symmetric here: the whole patch, in the patch frame
  Eigen::ArrayXXd pressure;  ///< nx × ny [Pa]
};

struct RailResult
{
  RailDeflection deflection;
  double lateral_force = 0;   ///< that bends the rail, outward [N]
  double vertical_force = 0;  ///< down [N]
};

struct WheelsetResult
{
  ContactStatus status = ContactStatus::invalid_input;
  std::string reason;                      ///< one sentence, empty when ok
  double y = 0, z = 0, yaw = 0, roll = 0;  ///< axle centre [m, rad], with the solved height and roll
  std::array<RailResult, 2> rail;          ///< by Side
  std::vector<PatchResult> patches;        ///< empty unless usable
};

/// True if the answer's pressures may be used.
inline bool isUsable(ContactStatus status)
{
  return status == ContactStatus::ok || status == ContactStatus::lift_off;
}

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

  const ContactModelConfig& config() const;

 private:
  class Chain;
  std::unique_ptr<Chain> chain_;
};
}  // namespace wheel_rail_contact
