// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/profile.h"
#include "wheelset_scene.h"

/// A crossing made of heads with round crowns.
namespace wheel_rail_contact::core::crossing_scene
{
/// Head with a crown of one arc, round corners and vertical sides, upright, in the profile frame [m].
struct RoundHead
{
  double y = 0;           ///< middle
  double top = 0;         ///< z of the top
  double half = 0.036;    ///< half width
  double crown = 0.12;    ///< radius of the crown
  double corner = 0.013;  ///< radius of the corners
};

inline std::vector<ProfileSection> sectionsOf(const RoundHead& head)
{
  constexpr double depth = 0.02;  // of the sides
  const double r = head.corner, inside = head.half - r, centre = head.top - head.crown;
  const double angle = std::asin(inside / (head.crown - r));  // of the place where a corner touches the crown
  const double z = centre + (head.crown - r) * std::cos(angle), turn = 0.5 * M_PI - angle;
  return {{LineSection{head.y - head.half, z - depth, 0, 1}, depth},
          {ArcSection{head.y - inside, z, r, M_PI, -1}, turn * r},
          {ArcSection{head.y, centre, head.crown, 0.5 * M_PI + angle, -1}, 2 * angle * head.crown},
          {ArcSection{head.y + inside, z, r, 0.5 * M_PI - angle, -1}, turn * r},
          {LineSection{head.y + head.half, z, 0, -1}, depth}};
}

inline std::shared_ptr<const Profile> profileOf(const RoundHead& head)
{
  return std::make_shared<const Profile>("head", sectionsOf(head));
}

constexpr double slope = 0.1;       ///< lateral slope of the wing rail: 1 in 10
constexpr double nose_begin = 0.2;  ///< x of the first section of the nose [m]
constexpr double end = 0.8;         ///< x of the last section of wing rail and nose [m]

/// A wing rail that moves outward from x = 0, and a nose that widens and rises beside it on the gauge side. Its gauge
/// face is that of the wing rail at the beginning.
inline std::shared_ptr<const RailSections> crossing()
{
  RailSeries wing{{-0.5, profileOf({}), {}}}, nose;
  for (int i = 0; i <= 8; ++i)
  {
    const double x = 0.1 * i;
    wing.push_back({x, i == 0 ? wing.front().profile : profileOf({slope * x}), {}});
    if (x >= nose_begin)
    {
      const double share = (x - nose_begin) / (end - nose_begin), half = 0.013 + 0.020 * share;
      nose.push_back({x, profileOf({-0.036 + half, -0.004 + 0.005 * share, half, 0.1, 0.010}), {}});
    }
  }
  return std::make_shared<const RailSections>(std::vector<RailSeries>{wing, nose},
                                              RailSections::Placement::coordinates);
}

/// Wheelset with S1002 wheels. The left rail is a crossing, the right one a head with a round crown.
inline ContactModelConfig scene()
{
  ContactModelConfig config = manchesterScene();
  config.track.rail_inclination = 0;
  config.rail_profile = profileOf({});
  config.rail_sections.left = crossing();
  return config;
}

inline WheelsetState stateOn(double x, double y, double wheel_load)
{
  WheelsetState state = stateAt(y, wheel_load);
  state.x = state.distance = x;
  return state;
}
}  // namespace wheel_rail_contact::core::crossing_scene
