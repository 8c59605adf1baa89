// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pressures.h"

using namespace wheel_rail_contact::core;
using pressures::Cells;

TEST(StressLayers, EqualTheSumOfAllCells)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  for (const auto& [nx, ny] : {std::pair{8, 6}, std::pair{5, 7}, std::pair{1, 4}, std::pair{6, 1}})
  {
    const Cells cells = pressures::random(nx, ny, seed);
    const std::vector<double> depths{0, 0.2, 3};
    const std::vector<StressLayer> layers = stressLayers(cells.grid, cells.pressure, 0.28, depths);
    ASSERT_EQ(layers.size(), depths.size());
    for (const StressLayer& layer : layers)
    {
      for (int j = 0; j < ny; ++j)
      {
        for (int i = 0; i < nx; ++i)
        {
          const Stress one = layer.at(i, j);
          const Stress other =
              stressAt(cells.grid, cells.pressure, 0.28, {cells.grid.x(i), cells.grid.y(j), layer.depth});
          EXPECT_NEAR(one.xx, other.xx, 1e-13);
          EXPECT_NEAR(one.yy, other.yy, 1e-13);
          EXPECT_NEAR(one.zz, other.zz, 1e-13);
          EXPECT_NEAR(one.yz, other.yz, 1e-13);
          EXPECT_NEAR(one.xz, other.xz, 1e-13);
          EXPECT_NEAR(one.xy, other.xy, 1e-13);
        }
      }
    }
  }
}

TEST(StressLayers, RejectNegativeDepths)
{
  const Cells cells = pressures::random(3, 2, 1);
  EXPECT_THROW(stressLayers(cells.grid, cells.pressure, 0.28, {0.1, -0.1}), std::invalid_argument);
}
