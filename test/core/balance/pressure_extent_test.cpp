// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/pressure_extent.h"

#include <gtest/gtest.h>

#include "../normal/problems.h"

namespace wheel_rail_contact::core
{
TEST(PressureExtent, CountsTheCellsOfTheWholeGrid)
{
  const Grid whole = problems::centredGrid(7, 9, 7e-3, 9e-3, false),
             half = problems::centredGrid(8, 9, 8e-3, 9e-3, true);
  for (const int cells : {0, 1, 2, 3, 4})
  {
    Eigen::ArrayXXd pressure = Eigen::ArrayXXd::Zero(7, 9), stored = Eigen::ArrayXXd::Zero(4, 9);
    pressure.row(3).segment(2, cells) = 1e9;
    stored.row(0).segment(2, cells) = 1e9;
    EXPECT_EQ(findExtent(whole, pressure).cells, cells);
    EXPECT_EQ(findExtent(half, stored).cells, 2 * cells);
    EXPECT_EQ(findExtent(whole, pressure).spike(), cells == 1 || cells == 2) << cells;
    EXPECT_EQ(findExtent(half, stored).spike(), cells == 1) << cells;
    EXPECT_EQ(findExtent(whole, pressure).empty(), cells == 0);
  }
}
}  // namespace wheel_rail_contact::core
