// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "mirror_image.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
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
