// SPDX-License-Identifier: BSD-3-Clause
#include "replay/profile_outlines.h"

#include <sstream>
#include <utility>

#include "core/balance/rail_support.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int points = 400;

void write(double y, double z, std::ostream& text)
{
  text.precision(7);
  text << y << ' ' << z << '\n';
}

template <typename Place>
std::string outline(const core::Profile& profile, const Place& place)
{
  std::ostringstream text;
  for (int i = 0; i < points; ++i)
  {
    const auto [y, z] = place(profile.length() * i / (points - 1));
    write(y, z, text);
  }
  return text.str();
}
}  // namespace

std::string railOutlineText(const core::ContactModelConfig& config, core::Side side)
{
  const core::PlacedRail rail = core::restingRail(config, side);
  return outline(rail.profile(),
                 [&rail](double u)
                 {
                   const core::PlanePoint p = rail.at(u);
                   return std::make_pair(p.y, p.z);
                 });
}

std::string railReferenceText(const core::ContactModelConfig& config, core::Side side)
{
  const core::PlanePoint point = core::restingRail(config, side).referencePoint();
  std::ostringstream text;
  write(point.y, point.z, text);
  return text.str();
}

std::string wheelOutlineText(const core::ContactModelConfig& config, core::Side side)
{
  const core::Profile& profile = *config.wheel_profile[side];
  const core::WheelsetConfig& wheelset = config.wheelset;
  return outline(profile,
                 [&](double u)
                 {
                   const core::CurvePoint p = profile.at(u);
                   return std::make_pair(wheelset.halfBase() + p.y, p.z - wheelset.rolling_radius[side]);
                 });
}
}  // namespace wheel_rail_contact
