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

// The overlap of the right wheel has one minimum, and a shoulder 8 mm beside it that touches as well: 71.63 mm² on 64 ×
// 192 cells over the whole overlap, 57.7 mm² without the second contact. From both directions and cold.
TEST(FineSweep, AContactOnAShoulderOfTheOverlapIsFound)
{
  constexpr double begin = -5.3e-3, end = -5.55e-3, shoulder = -5.415e-3, fine = 5e-6, expected = 71.63e-6;
  const ContactModelConfig config = manchesterScene();
  for (const double from : {begin, end, shoulder})
  {
    WheelsetContact contact(config);
    const double direction = from > shoulder ? -1 : 1;
    for (double y = from; direction * (shoulder - y) > 0.5 * fine; y += direction * fine)
    {
      contact.evaluate(stateAt(y, 1e5));
    }
    const WheelTotal total = wheelTotal(contact.evaluate(stateAt(shoulder, 1e5)), Side::right);
    EXPECT_EQ(total.patches, 2) << "from " << from;
    EXPECT_NEAR(total.area, expected, config.contact.tolerance * expected) << "from " << from;
  }
}
}  // namespace wheel_rail_contact::core
