// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
/// States that differ strongly from one another.
const WheelsetState varied_states[] = {stateAt(0, 1e5), stateAt(3e-3, 2e4), stateAt(-5.2e-3, 1e5, 0.005),
                                       stateAt(7e-3, 8e4), stateAt(-1e-3, 1e3)};

}  // namespace

TEST(ResetTest, AfterAResetResultsEqualThoseOfANewObject)
{
  const ContactModelConfig scene = manchesterScene();
  WheelsetContact used(scene);
  for (const WheelsetState& state : varied_states)
  {
    for (const WheelsetState& before : varied_states)
    {
      used.evaluate(before);
    }
    used.reset();
    WheelsetContact fresh(scene);
    expectSameBits(used.evaluate(state), fresh.evaluate(state));
  }
}

// At y = 95 mm a wheel is beside its rail.
TEST(ResetTest, AFailureWithGivenHeightOnBendingRailsHasNoLastingEffect)
{
  ContactModelConfig scene = manchesterScene();
  scene.rail_bending.model = RailBendingConfig::Model::compliance;
  scene.rail_bending.table = softPads();
  WheelsetContact by_load(scene);
  WheelsetState given = stateAt(2e-3, 1e5);
  const WheelsetResult& found = by_load.evaluate(given);
  given.z = found.z;
  given.roll = found.roll;
  scene.wheelset.solve_height_and_roll = false;
  WheelsetState lost = given;
  lost.y = 0.095;

  WheelsetContact used(scene);
  EXPECT_FALSE(isUsable(used.evaluate(lost).status));
  used.reset();
  WheelsetContact fresh(scene);
  const WheelsetResult& result = used.evaluate(given);
  ASSERT_TRUE(isUsable(result.status)) << result.reason;
  expectSameBits(result, fresh.evaluate(given));
}
