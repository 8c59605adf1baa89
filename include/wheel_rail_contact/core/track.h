// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Normal contact of a railway wheelset and two rails. SI units and radians; frames and signs as in the README.
namespace wheel_rail_contact::core
{
/// Sides of the track, seen in the direction of travel (+x).
enum class Side
{
  left = 0,  ///< y > 0
  right = 1  ///< y < 0
};

/// Position of the undeflected rails.
struct TrackConfig
{
  double gauge = 1.435;             ///< between the rails' gauge faces [m], > 0
  double gauge_depth = 0.014;       ///< below the plane on both rails' tops at which the gauge is measured [m], > 0
  double rail_inclination = 0.025;  ///< of each rail towards the track centre [rad]; 1:40 is atan(1/40)
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

/// Checks every option against its rule.
/// @throw std::invalid_argument with the option, its value and the broken rule.
void validate(const TrackConfig& track);
/// Same for the wheelset.
void validate(const WheelsetConfig& wheelset);
}  // namespace wheel_rail_contact::core
