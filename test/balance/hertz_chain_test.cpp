// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "wheel_rail_contact/normal/hertz.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double crown_radius = 0.3;
constexpr double half_head = 0.036;

/// Rail head of one arc, wide enough for the wheel, with upright sides for the gauge.
Profile arcRail()
{
  const double half_angle = std::asin(half_head / crown_radius);
  const double edge = -crown_radius * (1 - std::cos(half_angle));
  const double depth = 0.03;
  return {"arc",
          {{LineSection{-half_head, edge - depth, 0, 1}, depth},
           {ArcSection{0, -crown_radius, crown_radius, 0.5 * M_PI + half_angle, -1}, 2 * half_angle * crown_radius},
           {LineSection{half_head, edge, 0, -1}, depth}}};
}

/// Wheel of one straight line, rising to the field side by `slope`.
Profile coneWheel(double slope)
{
  const double length = std::hypot(1, slope);
  return {"cone", {{LineSection{-0.06, -0.06 * slope, 1 / length, slope / length}, 0.12 * length}}};
}

ContactModelConfig hertzScene(double slope)
{
  ContactModelConfig scene;
  scene.wheel_profile = std::make_shared<Profile>(coneWheel(slope));
  scene.rail_profile = std::make_shared<Profile>(arcRail());
  scene.track.cant = 0;
  scene.contact.method = NormalMethod::conjugate_gradient;
  scene.contact.cells_along = 128;
  scene.contact.cells_across = 128;
  return scene;
}
}  // namespace

// A cylinder or cone on one arc is Hertz's case: gap A x² + B y² with A = cos(a) / (2 R) at the touch (radius of the
// cone's normal section, R / cos(a)) and B = 1 / (2 * 300 mm). 0.1 % is wanted of pressure and approach. The mesh of
// 128² adds 2 * (1 / 116)² = 1.5e-4 to the pressure (an ellipse's top over a cell), less to the approach; the area is
// counted to a fraction of a cell along its edge, 0.5 %.
TEST(HertzChainTest, ConesOnAnArcGiveHertzsPressureAndApproach)
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

    const double cosine = 1 / std::hypot(1, slope);
    const double place = 0.5 * scene.track.gauge + half_head - crown_radius * std::sin(std::atan(slope));
    const double radius = scene.wheelset.rolling_radius - slope * (place - scene.wheelset.halfBase());
    const HertzContact hertz = hertzForForce({0.5 * cosine / radius, 0.5 / crown_radius},
                                             contactModulus(scene.wheel_material, scene.rail_material), load / cosine);
    std::printf("slope %.3f: max pressure %+.2e, approach %+.2e, area %+.2e against Hertz\n", slope,
                patch.max_pressure / hertz.max_pressure - 1, patch.approach / hertz.approach - 1,
                patch.area / hertz.area - 1);
    EXPECT_NEAR(patch.normal_force, load / cosine, 1e-4 * load);
    // Half-width over the rail's radius; the outermost of the 116 loaded columns' centres lie within one cell of the
    // edge.
    EXPECT_NEAR(patch.half_space_ratio, hertz.semi_axis_y / crown_radius, 0.02 * hertz.semi_axis_y / crown_radius);
    EXPECT_NEAR(patch.max_pressure, hertz.max_pressure, 1.15e-3 * hertz.max_pressure);
    EXPECT_NEAR(patch.approach, hertz.approach, 1e-3 * hertz.approach);
    EXPECT_NEAR(patch.area, hertz.area, 5e-3 * hertz.area);
  }
}

// A cylinder touches the crown at the running radius above it: the axle sinks by the approach.
TEST(HertzChainTest, AxleSinksByTheApproach)
{
  const ContactModelConfig scene = hertzScene(0);
  WheelsetContact contact(scene);
  const HertzContact hertz = hertzForForce({0.5 / scene.wheelset.rolling_radius, 0.5 / crown_radius},
                                           contactModulus(scene.wheel_material, scene.rail_material), 1e5);
  const WheelsetResult& result = contact.evaluate(stateAt(0, 1e5));
  ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
  EXPECT_NEAR(scene.wheelset.rolling_radius - result.z, hertz.approach, 1e-3 * hertz.approach);
}
