// SPDX-License-Identifier: BSD-3-Clause
// Sweep from the track centre to the flange in steps of 25 um on rigid rails, each state from the last result and from
// a cold start. The roll is bracketed, and the height of a wheel is unique at each roll: every state has a result, as
// doc/theory.md states.
#include <gtest/gtest.h>

#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double step = 25e-6;  ///< [m]
constexpr int steps = 400;

void sweep(const ContactModelConfig& config, double wheel_load, bool cold)
{
  WheelsetContact contact(config);
  for (int k = 0; k < steps; ++k)
  {
    if (cold)
    {
      contact.reset();
    }
    const double y = -k * step;
    const WheelsetResult& result = contact.evaluate(stateAt(y, wheel_load));
    EXPECT_TRUE(isUsable(result.status)) << "y " << y << (cold ? ", cold: " : ", warm: ") << result.reason;
  }
}
}  // namespace

TEST(FineSweep, FindsTheBalanceFromTheTrackCentreToTheFlange)
{
  for (const bool standard : {false, true})
  {
    ContactModelConfig config = manchesterScene();
    if (standard)
    {
      config.rail_profile = std::make_shared<Profile>(rail60E1());
    }
    for (const double wheel_load : {2e4, 1e5})
    {
      sweep(config, wheel_load, false);
      sweep(config, wheel_load, true);
    }
  }
}
}  // namespace wheel_rail_contact::core
