// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../normal/problems.h"
#include "wheelset_scene.h"

/// A cone on a rail head of one arc: a Hertz contact.
namespace wheel_rail_contact::core::round_bodies
{
constexpr double crown_radius = 0.3;
constexpr double half_head = 0.036;

/// Rail head of one arc, wide enough for the wheel, with vertical sides for the gauge.
inline Profile arcRail()
{
  const double half_angle = std::asin(half_head / crown_radius);
  const double edge = -crown_radius * (1 - std::cos(half_angle));
  const double depth = 0.03;
  return {"arc",
          {{LineSection{-half_head, edge - depth, 0, 1}, depth},
           {ArcSection{0, -crown_radius, crown_radius, 0.5 * M_PI + half_angle, -1}, 2 * half_angle * crown_radius},
           {LineSection{half_head, edge, 0, -1}, depth}}};
}

/// Wheel of one straight line that rises to the field side by `slope`.
inline Profile coneWheel(double slope)
{
  const double length = std::hypot(1, slope);
  return {"cone", {{LineSection{-0.06, -0.06 * slope, 1 / length, slope / length}, 0.12 * length}}};
}

inline ContactModelConfig scene(double slope)
{
  ContactModelConfig scene;
  scene.wheel_profile = std::make_shared<Profile>(coneWheel(slope));
  scene.rail_profile = std::make_shared<Profile>(arcRail());
  scene.track.rail_inclination = 0;
  return scene;
}

/// Contact of the left wheel under a load of each wheel [N], with the wheelset at `y`. The gap is A x² + B y² with A =
/// cos(a)/(2R), where R/cos(a) is the radius of the cone's normal section at the touch, and B = 1/(2 * 300 mm).
inline HertzContact exactContact(const ContactModelConfig& scene, double slope, double y, double load)
{
  const double cosine = 1 / std::hypot(1, slope);
  const double place = 0.5 * scene.track.gauge + half_head - crown_radius * std::sin(std::atan(slope));
  const double radius = scene.wheelset.rolling_radius.left - slope * (place - y - scene.wheelset.halfBase());
  return hertzForForce({0.5 * cosine / radius, 0.5 / crown_radius},
                       contactModulus(scene.wheel_material.left, scene.rail_material.left), load / cosine);
}
}  // namespace wheel_rail_contact::core::round_bodies
