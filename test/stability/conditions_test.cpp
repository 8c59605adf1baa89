// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "../core/balance/wheelset_scene.h"
#include "result_check.h"
#include "wheel_rail_contact/core/standard_profiles.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
ContactModelConfig flangeOnCompliantRail(double tolerance)
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<Profile>(s1002Wheel());
  config.rail_profile = std::make_shared<Profile>(rail60E1());
  config.track.rail_inclination = 0.05;
  config.contact.method = NormalMethod::automatic;
  config.contact.tolerance = tolerance;
  config.rail_bending.model = RailBendingConfig::Model::compliance;
  config.rail_bending.table = softPads();
  return config;
}

/// A flange in the gauge corner of a rail that gives way: as the rail moves out, the wheel comes down and slides along
/// the plane, over surfaces that turn by a radian. Pressures, pose and deflection of an answer have to belong together:
/// bodies placed by the answer and deformed by its pressures must touch where it presses, and nowhere else. Three
/// tolerances are left for the passes' own (descent, plane, roll and the rail's way are each open to about one).
TEST(ContactConditions, HoldWhereAFlangePushesItsRailAway)
{
  constexpr double tolerance = 0.004;
  const ContactModelConfig config = flangeOnCompliantRail(tolerance);
  WheelsetContact contact(config);
  ResultCheck check(contact.config());
  for (double y = 6e-3; y < 9.5e-3; y += 50e-6)
  {
    const WheelsetState state = stateAt(y, 8e4);
    const WheelsetResult& result = contact.evaluate(state);
    EXPECT_EQ(result.status, ContactStatus::ok) << "y = " << y << ": " << result.reason;
    EXPECT_TRUE(check.faults(state, result).empty()) << "y = " << y;
    EXPECT_LT(check.violation(), 3 * tolerance) << "y = " << y;
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core::stability
