// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/balance/patch_result.h"
#include "round_bodies.h"

using namespace wheel_rail_contact::core;

namespace
{
ContactModelConfig hertzScene(double slope)
{
  ContactModelConfig scene = round_bodies::scene(slope);
  scene.contact.method = NormalMethod::conjugate_gradient;
  scene.contact.cells_along = 128;
  scene.contact.cells_across = 128;
  return scene;
}
}  // namespace

// A cylinder or cone on one arc is a Hertz contact. Required accuracy of pressure and approach: 0.1 %. The mesh of 128²
// cells adds 2 * (1 / 116)² = 1.5e-4 to the pressure (curvature of the ellipsoid's top over a cell), and less to the
// approach. The area is determined to a fraction of a cell along its edge: 0.5 %.
TEST(HertzChainTest, ConesOnAnArcHaveThePressureAndApproachOfHertz)
{
  for (const double slope : {0.0, 0.025, 0.05})
  {
    const ContactModelConfig scene = hertzScene(slope);
    WheelsetContact contact(scene);
    const double load = 1e5;
    const WheelsetResult& result = contact.evaluate(stateAt(0, load));
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    ASSERT_EQ(result.patches.size(), 2U);
    const PatchResult& patch = result.patches.front();
    EXPECT_NEAR(patch.contact_angle, std::atan(slope), 1e-4);

    const HertzContact hertz = round_bodies::exactContact(scene, slope, 0, load);
    std::printf("slope %.3f: max pressure %+.2e, approach %+.2e, area %+.2e against Hertz\n", slope,
                patch.max_pressure / hertz.max_pressure - 1, patch.approach / hertz.approach - 1,
                patch.area / hertz.area - 1);
    EXPECT_NEAR(patch.normal_force, load * std::hypot(1, slope), 1e-4 * load);
    // Half-width over the radius of the rail. The centres of the outermost of the 116 loaded columns lie within one
    // cell of the edge.
    EXPECT_NEAR(patch.half_space_ratio, hertz.semi_axis_y / round_bodies::crown_radius,
                0.02 * hertz.semi_axis_y / round_bodies::crown_radius);
    EXPECT_EQ(patch.model_error, modelError(patch.half_space_ratio, false));  // the normals turn by less than 0.2 rad
    EXPECT_NEAR(patch.max_pressure, hertz.max_pressure, 1.15e-3 * hertz.max_pressure);
    EXPECT_NEAR(patch.approach, hertz.approach, 1e-3 * hertz.approach);
    EXPECT_NEAR(patch.area, hertz.area, 5e-3 * hertz.area);
  }
}

// A cylinder touches the crown at its rolling radius: the axle moves down by the approach.
TEST(HertzChainTest, AxleMovesDownByTheApproach)
{
  const ContactModelConfig scene = hertzScene(0);
  WheelsetContact contact(scene);
  const HertzContact hertz = round_bodies::exactContact(scene, 0, 0, 1e5);
  const WheelsetResult& result = contact.evaluate(stateAt(0, 1e5));
  ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
  EXPECT_NEAR(scene.wheelset.rolling_radius.left - result.z, hertz.approach, 1e-3 * hertz.approach);
}
