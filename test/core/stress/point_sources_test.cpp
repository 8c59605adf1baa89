// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/point_sources.h"

#include <gtest/gtest.h>

#include "pressures.h"

using namespace wheel_rail_contact::core;

// At a depth of 2.5 distances of the forces, all six components off the axes. The cells of stressAt() have steps of the
// pressure, the forces do not: 0.3 % of the highest pressure on 32 × 32 cells.
TEST(PointSources, AgreeWithTheSumOfAllCells)
{
  const pressures::Cells cells = pressures::hertz(32, 32, 1, 1.5);
  PointSources sources;
  sources.set(cells.grid, cells.pressure, 2, 0.1, {});  // lengths in units of 2
  PointSources::Places places;
  for (std::size_t k = 0; k < point_batch; ++k)
  {
    places.x[k] = 0.1F * static_cast<float>(k % 4) - 0.2F;
    places.y[k] = 0.15F * static_cast<float>(k / 4) - 0.1F;
    places.depth[k] = 0.25F + 0.02F * static_cast<float>(k);
  }
  const std::array<Stress, point_batch> stresses = sources.at(places, 0.3);
  for (std::size_t k = 0; k < point_batch; ++k)
  {
    const Stress expected =
        stressAt(cells.grid, cells.pressure, 0.3, {2.0 * places.x[k], 2.0 * places.y[k], 2.0 * places.depth[k]});
    EXPECT_NEAR(stresses[k].xx, expected.xx, 3e-3);
    EXPECT_NEAR(stresses[k].yy, expected.yy, 3e-3);
    EXPECT_NEAR(stresses[k].zz, expected.zz, 3e-3);
    EXPECT_NEAR(stresses[k].yz, expected.yz, 3e-3);
    EXPECT_NEAR(stresses[k].xz, expected.xz, 3e-3);
    EXPECT_NEAR(stresses[k].xy, expected.xy, 3e-3);
  }
}
