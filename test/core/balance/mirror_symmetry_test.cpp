// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
WheelsetState mirrored(WheelsetState state)
{
  state.y = -state.y;
  state.yaw = -state.yaw;
  state.roll = -state.roll;
  state.torque_x = -state.torque_x;
  return state;
}

std::vector<const PatchResult*> patchesOf(const WheelsetResult& result, Side side)
{
  std::vector<const PatchResult*> found;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      found.push_back(&patch);
    }
  }
  return found;
}

/// Equal bits, no tolerance.
void expectMirrorImage(const PatchResult& patch, const PatchResult& image)
{
  EXPECT_EQ(patch.pose.x, image.pose.x);
  EXPECT_EQ(patch.pose.y, -image.pose.y);
  EXPECT_EQ(patch.pose.z, image.pose.z);
  EXPECT_EQ(patch.pose.angle, -image.pose.angle);
  EXPECT_EQ(patch.contact_angle, image.contact_angle);
  EXPECT_EQ(patch.normal_force, image.normal_force);
  EXPECT_EQ(patch.approach, image.approach);
  EXPECT_EQ(patch.area, image.area);
  EXPECT_EQ(patch.max_pressure, image.max_pressure);
  EXPECT_EQ(patch.error_estimate, image.error_estimate);
  EXPECT_EQ(patch.iterations, image.iterations);
  EXPECT_EQ(patch.residual, image.residual);
  EXPECT_TRUE((patch.pressure == image.pressure.rowwise().reverse()).all());
}

void expectMirrorImage(const WheelsetResult& result, const WheelsetResult& image)
{
  EXPECT_EQ(result.status, image.status);
  EXPECT_EQ(result.z, image.z);
  EXPECT_EQ(result.roll, -image.roll);
  for (const Side side : {Side::left, Side::right})
  {
    const Side other = side == Side::left ? Side::right : Side::left;
    const RailResult& rail = result.rail[static_cast<std::size_t>(side)];
    const RailResult& other_rail = image.rail[static_cast<std::size_t>(other)];
    EXPECT_EQ(rail.lateral_force, other_rail.lateral_force);
    EXPECT_EQ(rail.vertical_force, other_rail.vertical_force);
    EXPECT_EQ(rail.deflection.lateral, other_rail.deflection.lateral);
    EXPECT_EQ(rail.deflection.roll, other_rail.deflection.roll);
    const auto patches = patchesOf(result, side);
    const auto images = patchesOf(image, other);
    ASSERT_EQ(patches.size(), images.size());
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
      expectMirrorImage(*patches[k], *images[k]);
    }
  }
}

class MirrorSymmetryTest : public testing::Test
{
 protected:
  double within(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  WheelsetState randomState()
  {
    WheelsetState state = stateAt(within(-6e-3, 6e-3), std::exp(within(std::log(2e3), std::log(2e5))));
    state.yaw = within(-1, 1) > 0 ? 0 : within(-0.02, 0.02);
    state.torque_x = within(-0.5, 0.5) * state.force_z * scene_.wheelset.halfBase();
    return state;
  }

  const unsigned seed_ = 20111U;
  testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(seed_)};
  std::mt19937 random_{seed_};
  ContactModelConfig scene_ = manchesterScene();
};
}  // namespace

// Both sides use the same arithmetic. The results are bit-equal from a cold start and along a sweep, on rigid and on
// soft rails.
TEST_F(MirrorSymmetryTest, MirroredStateHasTheMirroredResult)
{
  for (const bool soft : {false, true})
  {
    scene_.rail_bending.model = soft ? RailBendingConfig::Model::compliance : RailBendingConfig::Model::none;
    scene_.rail_bending.table = softPads();
    WheelsetContact contact(scene_);
    WheelsetContact mirror(scene_);
    for (int i = 0; i < 40; ++i)
    {
      const WheelsetState state = randomState();
      if (i % 2 == 0)
      {
        contact.reset();
        mirror.reset();
      }
      SCOPED_TRACE("y " + std::to_string(state.y) + " yaw " + std::to_string(state.yaw));
      expectMirrorImage(contact.evaluate(state), mirror.evaluate(mirrored(state)));
    }
  }
}
