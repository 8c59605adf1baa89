// SPDX-License-Identifier: BSD-3-Clause
#include "../core/balance/crossing_scene.h"
#include "result_check.h"
#include "scene.h"

using namespace wheel_rail_contact::core;
using namespace wheel_rail_contact::core::stability;

namespace
{
/// The flange touches the gauge corner of a compliant rail. While the rail is deflected outward, the wheel moves down,
/// and the contact moves along surfaces whose normals turn by up to one radian. Pressures, pose and rail deflection of
/// a result must be consistent: the bodies, placed and deformed according to the result, touch where there is pressure
/// and nowhere else. The limit is three tolerances, because penetration, roll and rail deflection have errors of up to
/// about one tolerance each.
TEST(ContactConditions, HoldForAFlangeOnACompliantRail)
{
  constexpr double tolerance = 0.004;
  ContactModelConfig config = standardOn(softPads());
  config.track.rail_inclination = 0.05;
  config.contact.tolerance = tolerance;
  WheelsetContact contact(config);
  ResultCheck check(contact.config());
  for (double y = 6e-3; y < 9.5e-3; y += 50e-6)
  {
    const WheelsetState state = stateAt(y, 8e4);
    const WheelsetResult& result = contact.evaluate(state);
    EXPECT_EQ(result.status, ContactStatus::ok) << "y = " << y << ": " << result.reason;
    for (const std::string& fault : check.faults(state, result))
    {
      ADD_FAILURE() << fault << ", y = " << y;
    }
    EXPECT_LT(check.violation(), 3 * tolerance) << "y = " << y;
  }
}

/// A wheel that is carried by a wing rail and by the nose beside it. The limit is the same.
TEST(ContactConditions, HoldForAWheelOnTwoPartsOfARail)
{
  constexpr double tolerance = 0.004;
  ContactModelConfig config = crossing_scene::scene();
  config.contact.tolerance = tolerance;
  bend(config, softPads());
  WheelsetContact contact(config);
  ResultCheck check(contact.config());
  int on_both = 0;
  for (double x = 0.3; x < 0.75; x += 0.002)
  {
    const WheelsetState state = crossing_scene::stateOn(x, 1e-3 * std::sin(20 * x), 8e4);
    const WheelsetResult& result = contact.evaluate(state);
    EXPECT_TRUE(isUsable(result.status)) << "x = " << x << ": " << result.reason;
    for (const std::string& fault : check.faults(state, result))
    {
      ADD_FAILURE() << fault << ", x = " << x;
    }
    EXPECT_LT(check.violation(), 3 * tolerance) << "x = " << x;
    on_both += wheelTotal(result, Side::left).patches > 1 ? 1 : 0;
  }
  EXPECT_GT(on_both, 5) << "the wheel must touch both";
}

/// The wheel profile passes through points 0.25 mm apart with noise of 0.5 um. It has waves between the columns of a
/// coarse grid. The reference has 192 x 256 cells, which resolve the waves. The error of the highest pressure must be
/// within the error estimate in 92 of 100 patches, and always within three times the estimate plus the error of the
/// reference.
TEST(ErrorEstimate, HoldsOnAWavyProfile)
{
  constexpr double error_of_reference = 0.0024;  // mean difference from 192 x 512 cells
  const SceneProfile wheel = wheelProfiles()[1];
  const std::vector<SceneProfile> rails = railProfiles();
  int held = 0, count = 0;
  for (const SceneProfile& rail : {rails[0], rails[1]})
  {
    ContactModelConfig config;
    config.wheel_profile = wheel.profile;
    config.rail_profile = rail.profile;
    config.track.rail_inclination = 0.025;
    config.contact.tolerance = 0.1;
    WheelsetContact contact(config);
    config.contact = {NormalMethod::conjugate_gradient, 1e-3, 192, 256};
    WheelsetContact reference(config);
    for (double y = -6e-3; y <= 6e-3; y += 137e-6)
    {
      const WheelsetState state = stateAt(y, 1e5);
      const WheelsetResult &result = contact.evaluate(state), &fine = reference.evaluate(state);
      ASSERT_TRUE(isUsable(result.status) && isUsable(fine.status)) << y;
      for (const Side side : {Side::left, Side::right})
      {
        const PatchResult &found = highestOf(patchesOf(result, side)), &exact = highestOf(patchesOf(fine, side));
        const double error = std::abs(found.max_pressure / exact.max_pressure - 1);
        held += error <= found.error_estimate ? 1 : 0;
        ++count;
        EXPECT_LT(error, 3 * found.error_estimate + error_of_reference) << rail.name << ", y = " << y;
      }
    }
  }
  // 93 % were measured: 9 to 20 columns are a small sample of the waves.
  EXPECT_GE(held, 0.92 * count) << count;
}
}  // namespace
