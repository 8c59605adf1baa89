// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "../core/balance/wheelset_scene.h"
#include "random_scene.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
/// A wheel's patch of the highest pressure.
const PatchResult* hardest(const WheelsetResult& result, Side side)
{
  const PatchResult* found = nullptr;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side && (found == nullptr || patch.max_pressure > found->max_pressure))
    {
      found = &patch;
    }
  }
  return found;
}

/// A profile that passes through every one of its points, 0.25 mm apart and 0.5 um off, waves between the columns of a
/// coarse grid. The highest pressure has to be known to within its estimate all the same, in 99 of 100 patches, and is
/// never off by more than 1.25 times that and what the truth is off by; against 192 x 256 cells, which see the waves.
TEST(Roughness, EstimatesHoldOnProfilesThroughPoints)
{
  constexpr double error_of_truth = 0.0024;  // mean difference to 192 x 512 cells
  const Pool pool = makePool({});
  int held = 0, count = 0;
  for (const NamedProfile& rail : {pool.rails[0], pool.rails[1]})
  {
    ContactModelConfig config;
    config.wheel_profile = pool.wheels[1].profile;
    config.rail_profile = rail.profile;
    config.track.rail_inclination = 0.025;
    config.contact.tolerance = 0.1;
    WheelsetContact contact(config);
    config.contact.method = NormalMethod::conjugate_gradient;
    config.contact.cells_along = 192;
    config.contact.cells_across = 256;
    config.contact.tolerance = 1e-3;
    WheelsetContact truth(config);
    for (double y = -6e-3; y <= 6e-3; y += 137e-6)
    {
      const WheelsetState state = stateAt(y, 1e5);
      const WheelsetResult &result = contact.evaluate(state), &fine = truth.evaluate(state);
      ASSERT_TRUE(isUsable(result.status) && isUsable(fine.status)) << y;
      for (const Side side : {Side::left, Side::right})
      {
        const PatchResult &found = *hardest(result, side), &exact = *hardest(fine, side);
        const double error = std::abs(found.max_pressure / exact.max_pressure - 1);
        held += error <= found.error_estimate ? 1 : 0;
        ++count;
        EXPECT_LT(error, 1.25 * found.error_estimate + error_of_truth) << rail.name << ", y = " << y;
      }
    }
  }
  EXPECT_GE(held, 0.99 * count) << count;
}
}  // namespace
}  // namespace wheel_rail_contact::core::stability
