// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "wheel_rail_contact/core/sides.h"
#include "wheel_rail_contact/core/track_line.h"

/// Normal contact of the wheels of a railway wheelset with two rails.
///
/// SI units, angles in radians. Track frame: x forward along the track, y left, z up; the origin is on the centre line,
/// and z = 0 is the plane on the tops of both undeflected rails. "Outward" is the direction from the track centre to
/// the field side of a rail. doc/glossary.md explains all terms.
namespace wheel_rail_contact::core
{
/// Position and inclination of the undeflected rails.
struct TrackConfig
{
  double gauge = 1.435;        ///< distance between the gauge faces of both rails [m], 0.2 to 3
  double gauge_depth = 0.014;  ///< depth below the tops of the rails at which the gauge is measured [m], 1e-5 to 0.1
  /// Inclination of each rail, top towards the track centre [rad]; at most 0.2. 1:40 is atan(1/40). This is not the
  /// cant (superelevation) of the track.
  Sides<double> rail_inclination = 0.025;
  /// Irregularities along the track, see WheelsetState::distance; null: the ideal track.
  std::shared_ptr<const TrackLine> line{};
};

/// Dimensions of the wheelset, and the part of its pose that is solved.
struct WheelsetConfig
{
  Sides<double> rolling_radius = 0.460;  ///< radius of each wheel at its running circle [m], 0.05 to 2
  double flange_back_distance = 1.360;   ///< back-to-back distance: between the backs of both flanges [m], 0.2 to 3
  double tape_circle = 0.070;            ///< distance from the flange back to the running circle [m], 0.005 to 0.5
  /// True: height and roll of the axle are solved from the load. False: they are given in each WheelsetState, and the
  /// forces follow from them.
  bool solve_height_and_roll = true;

  /// Equilibrium that determines height and roll, if they are solved.
  enum class Balance
  {
    wheel_loads,  ///< the wheel loads follow from force_z and torque_x alone, as vertical forces at the running circles
    moments       ///< forces and moments about the axle centre, with the moment of the lateral normal forces
  };
  Balance balance = Balance::wheel_loads;  ///< see WheelsetState::torque_x

  /// Mean radius of both wheels at their running circles [m].
  double meanRadius() const { return 0.5 * (rolling_radius.left + rolling_radius.right); }
  /// Half the distance between the running circles of both wheels [m].
  double halfBase() const { return 0.5 * flange_back_distance + tape_circle; }
};

/// Checks that every parameter is within its range.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const TrackConfig& track);
/// Checks that every parameter is within its range.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const WheelsetConfig& wheelset);
}  // namespace wheel_rail_contact::core
