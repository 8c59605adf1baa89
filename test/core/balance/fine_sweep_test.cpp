// SPDX-License-Identifier: BSD-3-Clause
// Sweep from the track centre to the flange in steps of 25 um on rigid rails. Checks the statement of doc/theory.md on
// failed states.
#include <gtest/gtest.h>

#include <cstdio>

#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double step = 25e-6;  ///< [m]
constexpr int steps = 400;

struct Count
{
  int states = 0;
  int refused = 0;
};

void sweep(const ContactModelConfig& config, double wheel_load, bool cold, Count& count)
{
  WheelsetContact contact(config);
  for (int k = 0; k < steps; ++k)
  {
    if (cold)
    {
      contact.reset();
    }
    const double y = -k * step;
    ++count.states;
    if (!isUsable(contact.evaluate(stateAt(y, wheel_load)).status))
    {
      ++count.refused;
      EXPECT_GT(y, -6.5e-3);
      EXPECT_LT(y, -6.25e-3);
    }
  }
}
}  // namespace

// Where one overlap interval contains tread and flange, rounding may decide. With other instruction sets one state may
// fail.
TEST(FineSweep, FindsTheBalanceFromTheTrackCentreToTheFlange)
{
  Count count;
  for (const bool standard : {false, true})
  {
    ContactModelConfig config = manchesterScene();
    if (standard)
    {
      config.rail_profile = std::make_shared<Profile>(rail60E1());
    }
    for (const double wheel_load : {2e4, 1e5})
    {
      sweep(config, wheel_load, false, count);
      sweep(config, wheel_load, true, count);
    }
  }
  std::printf("%d of %d states without a solution\n", count.refused, count.states);
  EXPECT_LE(count.refused, 1);
}
}  // namespace wheel_rail_contact::core
