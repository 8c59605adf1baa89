// SPDX-License-Identifier: BSD-3-Clause
// Requirement of a co-simulation at 1 kHz: a rail whose profile changes along the line allocates no memory.
#include "../allocation_counter.h"
#include "core/profile/along/changing_profile.h"
#include "section_scenes.h"

#ifdef __GLIBC__
namespace wheel_rail_contact::core
{
namespace
{
using namespace section_scenes;

// The parts begin and end between sections of one another, and their profiles have different numbers of curves.
TEST(HotPath, ChangingProfileAllocatesNothingAfterReserve)
{
  const auto a = shared(profileOf({})), b = shared(profileOf({0.01, 0, 0.03})), nose = shared(profileOf({0.1}));
  const auto later = shared(profileOf({0.12, 0.002, 0.05}));
  const RailSections rail({{{0, a, {}}, {2, b, {}}, {4, b, {}}, {6, a, {}}},
                           {{0.7, nose, {}}, {3, later, {}}, {3.5, nose, {}}},
                           {{1.1, nose, {}}, {1.3, later, {}}}},
                          RailSections::Placement::coordinates);
  ChangingProfile changing(rail);
  changing.reserve();
  const auto go_and_return = [&]
  {
    for (int i = -600; i <= 600; ++i)
    {
      changing.moveTo(0.01 * (600 - std::abs(i)));
    }
  };
  EXPECT_EQ(allocationsOf(go_and_return), 0);
}
}  // namespace
}  // namespace wheel_rail_contact::core
#endif
