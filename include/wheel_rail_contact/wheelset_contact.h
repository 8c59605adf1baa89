// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "wheel_rail_contact/geometry/profile.h"
#include "wheel_rail_contact/normal/problem.h"
#include "wheel_rail_contact/rail/compliance.h"

namespace wheel_rail_contact
{
/// Sides of the track, seen in the direction of travel (+x).
enum class Side
{
  left = 0,  ///< y > 0
  right = 1  ///< y < 0
};

struct TrackConfig
{
  double gauge = 1.435;         ///< between the rails' gauge faces [m], > 0
  double gauge_depth = 0.014;   ///< below the plane on both rails' tops at which the gauge is measured [m], > 0
  double cant = 0.025;          ///< inclination of each rail towards the track's centre [rad]
};

struct WheelsetConfig
{
  double rolling_radius = 0.460;       ///< of the running (tape) circle [m], > 0
  double flange_back_distance = 1.360; ///< between the flange backs [m], > 0
  double tape_circle = 0.070;          ///< from the flange back to the running circle [m], > 0
  bool solve_height_and_roll = true;   ///< true: z and roll follow from the load; false: they are given

  /// Half the distance of the running circles [m].
  double halfBase() const { return 0.5 * flange_back_distance + tape_circle; }
};

enum class NormalMethod
{
  conjugate_gradient,
  seidel,          ///< the paper's iteration, repaired: exact coefficients, load inside
  seidel_printed   ///< the paper's iteration as printed: point forces, load steps
};

struct ContactConfig
{
  NormalMethod method = NormalMethod::conjugate_gradient;
  double tolerance = 0.01;  ///< wanted relative error of max pressure, area and approach [-]; chooses the grid
  int cells_along = 0;      ///< grid given by hand; 0: from the tolerance
  int cells_across = 0;     ///< both or none
};

struct RailBendingConfig
{
  enum class Model
  {
    none,
    prescribed,
    compliance
  };
  enum class LateralForce
  {
    contact,  ///< the outward share of the contact's normal forces
    topic,    ///< given with every state (WheelsetState::rail_lateral_force)
    constant  ///< `lateral_force_value`
  };
  Model model = Model::none;
  RailDeflection prescribed;         ///< for model prescribed, the same on both rails
  ComplianceTable table;             ///< for model compliance
  LateralForce lateral_force = LateralForce::contact;
  double lateral_force_value = 0;    ///< outward positive [N]
};

struct ContactModelConfig
{
  std::shared_ptr<const Profile> wheel_profile;
  std::shared_ptr<const Profile> rail_profile;
  Material wheel_material;
  Material rail_material;
  TrackConfig track;
  WheelsetConfig wheelset;
  ContactConfig contact;
  RailBendingConfig rail_bending;
};

/// What is known of a wheelset at one instant; track frame (x forward, y left, z up).
struct WheelsetState
{
  double y = 0;         ///< axle centre, to the left [m]
  double z = 0;         ///< axle centre, up [m]; used only if height and roll are given
  double yaw = 0;       ///< about z [rad]
  double roll = 0;      ///< about x [rad]; used only if height and roll are given
  double force_z = 0;   ///< vehicle's force on the axle centre, up [N]; negative presses down
  double torque_x = 0;  ///< vehicle's moment on the axle centre about x [N m]
  std::array<double, 2> rail_lateral_force{};  ///< outward force on the rail by Side [N], for LateralForce::topic
};

enum class ContactStatus
{
  ok,                  ///< every loaded wheel in contact, usable
  lift_off,            ///< at least one wheel carries nothing, the rest is solved; usable
  off_profile,         ///< contact would lie beyond the end of a profile
  not_converged,       ///< normal solution, balance or coupling did not converge
  invalid_input        ///< NaN or infinite input, or angles out of range
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
  Grid grid;                  ///< never symmetric here: the whole patch, in the patch frame
  Eigen::ArrayXXd pressure;   ///< nx × ny [Pa]
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
  std::string reason;               ///< one sentence, empty when ok
  double y = 0, z = 0, yaw = 0, roll = 0;  ///< axle centre [m, rad], with the solved height and roll
  std::array<RailResult, 2> rail;   ///< by Side
  std::vector<PatchResult> patches; ///< empty unless usable
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
