// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>

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
  double gauge = 1.435;        ///< between the rails' gauge faces [m], > 0
  double gauge_depth = 0.014;  ///< below the plane on both rails' tops at which the gauge is measured [m], > 0
  double cant = 0.025;         ///< inclination of each rail towards the track's centre [rad]
};

struct WheelsetConfig
{
  double rolling_radius = 0.460;        ///< of the running (tape) circle [m], > 0
  double flange_back_distance = 1.360;  ///< between the flange backs [m], > 0
  double tape_circle = 0.070;           ///< from the flange back to the running circle [m], > 0
  bool solve_height_and_roll = true;    ///< true: z and roll follow from the load; false: they are given

  /// Half the distance of the running circles [m].
  double halfBase() const { return 0.5 * flange_back_distance + tape_circle; }
};

enum class NormalMethod
{
  automatic,           ///< conjugate gradients on the coarsest grid whose estimated error meets the tolerance
  hertz,               ///< closed form with the local curvatures
  kik_piotrowski,      ///< strips over the virtual penetration
  seidel,              ///< the paper's iteration, repaired: exact coefficients, load inside
  seidel_printed,      ///< the paper's iteration as printed: point forces, load steps
  conjugate_gradient,  ///< on one grid
};

constexpr std::array<NormalMethod, 6> all_normal_methods{
    NormalMethod::automatic, NormalMethod::hertz,          NormalMethod::kik_piotrowski,
    NormalMethod::seidel,    NormalMethod::seidel_printed, NormalMethod::conjugate_gradient};

/// Name as in the parameter `contact/method`, alive as long as the program.
const char* toString(NormalMethod method);

struct ContactConfig
{
  NormalMethod method = NormalMethod::automatic;
  double tolerance = 0.01;  ///< wanted relative error of max pressure, area and approach [-]; in (0, 1)
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
  RailDeflection prescribed;  ///< for model prescribed, the same on both rails
  ComplianceTable table;      ///< for model compliance
  LateralForce lateral_force = LateralForce::contact;
  double lateral_force_value = 0;  ///< outward positive [N]
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

/// Checks every option against its rule.
/// @throw std::invalid_argument naming the option, its value and the broken rule.
void validate(const ContactModelConfig& config);
}  // namespace wheel_rail_contact
