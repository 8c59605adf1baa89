// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "wheel_rail_contact/core/profile_reader.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Wheelset of two standard profiles on rigid rails, inclined 1:40.
WheelsetContact wheelsetOf(const std::string& wheel, const std::string& rail)
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<const Profile>(loadProfile(wheel, ProfileKind::wheel));
  config.rail_profile = std::make_shared<const Profile>(loadProfile(rail, ProfileKind::rail));
  return WheelsetContact(config);
}

WheelsetState loadedAt(double y)
{
  WheelsetState state;
  state.y = y;
  state.force_z = -200e3;
  return state;
}

TEST(StandardProfiles, EachWheelStandsOnEachRail)
{
  for (const std::string& wheel : standardProfileNames(ProfileKind::wheel))
  {
    for (const std::string& rail : standardProfileNames(ProfileKind::rail))
    {
      WheelsetContact contact = wheelsetOf(wheel, rail);
      for (const double y : {-5e-3, 0.0, 5e-3})
      {
        const WheelsetResult& result = contact.evaluate(loadedAt(y));
        EXPECT_EQ(result.status, ContactStatus::ok) << wheel << " on " << rail << " at " << y << ": " << result.reason;
        EXPECT_GE(result.patches.size(), 2U) << wheel << " on " << rail << " at " << y;
      }
    }
  }
}

TEST(StandardProfiles, ConeOnACrownOfTheSameInclinationIsAHertzContact)
{
  // The cone 1:40 touches the crowns of rails inclined 1:40. The highest pressures are those of Hertz (1882) for 100 kN
  // / cos(atan(1/40)), a rolling radius of 0.46 m / cos(atan(1/40)) and the radius of the crown, with elliptic
  // integrals from SciPy. The ellipses are at most 10.9 mm wide, less than each crown (11.787 mm in 56E1).
  const std::pair<const char*, double> crowns[] = {
      {"60E1", 1227.16e6}, {"54E1", 1227.16e6}, {"54E3", 1227.16e6}, {"60E2", 1424.37e6}, {"56E1", 1219.95e6}};
  for (const auto& [rail, pressure] : crowns)
  {
    WheelsetContact contact = wheelsetOf("cone_1_40", rail);
    const WheelsetResult& result = contact.evaluate(loadedAt(0.0));
    ASSERT_EQ(result.patches.size(), 2U) << rail;
    for (const PatchResult& patch : result.patches)
    {
      // Differences: the radius of the wheel over the patch, and the discretisation.
      EXPECT_NEAR(patch.max_pressure, pressure, 0.002 * pressure) << rail;
    }
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
