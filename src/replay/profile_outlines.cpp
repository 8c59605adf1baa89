// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/replay/profile_outlines.h"

#include <sstream>

#include "wheel_rail_contact/geometry/placement.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int points = 400;

template <typename Place>
std::string outline(const Profile& profile, const Place& place)
{
  std::ostringstream text;
  text.precision(7);
  for (int i = 0; i < points; ++i)
  {
    const auto [y, z] = place(profile.length() * i / (points - 1));
    text << y << ' ' << z << '\n';
  }
  return text.str();
}
}  // namespace

std::string railOutlineText(const ContactModelConfig& config)
{
  const PlacedRail rail(config.rail_profile, config.track);
  return outline(*config.rail_profile,
                 [&rail](double u)
                 {
                   const PlanePoint p = rail.at(u);
                   return std::make_pair(p.y, p.z);
                 });
}

std::string wheelOutlineText(const ContactModelConfig& config)
{
  const Profile& profile = *config.wheel_profile;
  const WheelsetConfig& wheelset = config.wheelset;
  return outline(profile,
                 [&](double u)
                 {
                   const CurvePoint p = profile.at(u);
                   return std::make_pair(wheelset.halfBase() + p.y, p.z - wheelset.rolling_radius);
                 });
}
}  // namespace wheel_rail_contact
