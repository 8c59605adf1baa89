// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/patch_result.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace wheel_rail_contact::core;

TEST(ModelError, GrowsWithTheRatioAndIsLargerForParallelNormals)
{
  double turned = 0, parallel = 0;
  for (const double ratio : {0.0, 0.1, 0.2, 0.4, 0.5})
  {
    EXPECT_GT(modelError(ratio, true), turned);
    EXPECT_GT(modelError(ratio, false), parallel);
    turned = modelError(ratio, true);
    parallel = modelError(ratio, false);
    EXPECT_GE(parallel, turned);
  }
}

TEST(ModelError, IsOneBeyondTheContactsThatWereCompared)
{
  EXPECT_EQ(modelError(0.6, true), 1);
  EXPECT_EQ(modelError(std::nan(""), true), 1);
}
