// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>

#include "wheel_rail_contact/geometry/profile.h"
#include "wheel_rail_contact/normal/problem.h"
#include "wheel_rail_contact/rail/compliance.h"

/// Normal contact of a railway wheelset and two rails. SI units and radians; frames and signs as in the README.
namespace wheel_rail_contact
{
/// Sides of the track, seen in the direction of travel (+x).
enum class Side
{
  left = 0,  ///< y > 0
  right = 1  ///< y < 0
};

/// The track at rest.
struct TrackConfig
{
  double gauge = 1.435;        ///< between the rails' gauge faces [m], > 0
  double gauge_depth = 0.014;  ///< below the plane on both rails' tops at which the gauge is measured [m], > 0
  double cant = 0.025;         ///< inclination of each rail towards the track's centre [rad]
};

/// The wheelset, and what of its pose is solved.
struct WheelsetConfig
{
  double rolling_radius = 0.460;        ///< of the running (tape) circle [m], > 0
  double flange_back_distance = 1.360;  ///< between the flange backs [m], > 0
  double tape_circle = 0.070;           ///< from the flange back to the running circle [m], > 0
  bool solve_height_and_roll = true;    ///< true: z and roll follow from the load; false: they are given

  /// Half the distance of the running circles [m].
  double halfBase() const { return 0.5 * flange_back_distance + tape_circle; }
};

/// Methods for the normal problem.
enum class NormalMethod
{
  automatic,           ///< Hertz between round bodies, else the cheapest grid whose estimated error meets the tolerance
  hertz,               ///< closed form with the local curvatures
  kik_piotrowski,      ///< strips over the virtual penetration
  seidel,              ///< the paper's iteration, repaired: exact coefficients, load inside
  seidel_printed,      ///< the paper's iteration as printed: point forces, load steps
  conjugate_gradient,  ///< on one grid
};

/// All of them.
constexpr std::array<NormalMethod, 6> all_normal_methods{
    NormalMethod::automatic, NormalMethod::hertz,          NormalMethod::kik_piotrowski,
    NormalMethod::seidel,    NormalMethod::seidel_printed, NormalMethod::conjugate_gradient};

/// Name as in the parameter `contact/method`, alive as long as the program.
const char* toString(NormalMethod method);

/// How the pressure is solved, and how finely.
struct ContactConfig
{
  NormalMethod method = NormalMethod::automatic;  ///< `auto`: the cheapest that meets the tolerance
  double tolerance = 0.01;  ///< wanted relative error of max pressure, area and approach [-]; in (0, 1)
  int cells_along = 0;      ///< grid given by hand; 0: from the tolerance
  int cells_across = 0;     ///< both or none
};

/// How the rails give way.
struct RailBendingConfig
{
  /// What sets the rails' deflection.
  enum class Model
  {
    none,        ///< rails stay where they are
    prescribed,  ///< by `prescribed`
    compliance   ///< by `table` and the forces
  };
  /// The lateral force that bends a rail.
  enum class LateralForce
  {
    contact,  ///< the outward share of the contact's normal forces
    topic,    ///< given with every state (WheelsetState::rail_lateral_force)
    constant  ///< `lateral_force_value`
  };
  Model model = Model::none;                           ///< what sets the deflection
  RailDeflection prescribed;                           ///< for model prescribed, the same on both rails
  ComplianceTable table;                               ///< for model compliance
  LateralForce lateral_force = LateralForce::contact;  ///< for model compliance
  double lateral_force_value = 0;                      ///< outward positive [N]
};

/// Everything a WheelsetContact is told when it is made.
struct ContactModelConfig
{
  std::shared_ptr<const Profile> wheel_profile;  ///< of the left wheel; the right one mirrors it
  std::shared_ptr<const Profile> rail_profile;   ///< of the left rail, upright; the right one mirrors it
  Material wheel_material;                       ///< of both wheels
  Material rail_material;                        ///< of both rails
  TrackConfig track;                             ///< where the rails stand
  WheelsetConfig wheelset;                       ///< where the wheels are on their axle
  ContactConfig contact;                         ///< method and tolerance
  RailBendingConfig rail_bending;                ///< how the rails give way
};

/// Checks every option against its rule.
/// @throw std::invalid_argument naming the option, its value and the broken rule.
void validate(const ContactModelConfig& config);
}  // namespace wheel_rail_contact
