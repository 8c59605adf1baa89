// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstddef>

#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Expects two patches to be equal in every bit.
inline void expectSameBits(const PatchResult& a, const PatchResult& b)
{
  EXPECT_EQ(a.side, b.side);
  EXPECT_EQ(a.pose.y, b.pose.y);
  EXPECT_EQ(a.pose.z, b.pose.z);
  EXPECT_EQ(a.pose.angle, b.pose.angle);
  EXPECT_EQ(a.normal_force, b.normal_force);
  EXPECT_EQ(a.max_pressure, b.max_pressure);
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.approach, b.approach);
  EXPECT_EQ(a.error_estimate, b.error_estimate);
  ASSERT_EQ(a.pressure.rows(), b.pressure.rows());
  ASSERT_EQ(a.pressure.cols(), b.pressure.cols());
  EXPECT_TRUE((a.pressure == b.pressure).all());
}

/// Expects two results to be equal in every bit.
inline void expectSameBits(const WheelsetResult& a, const WheelsetResult& b)
{
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.z, b.z);
  EXPECT_EQ(a.roll, b.roll);
  ASSERT_EQ(a.patches.size(), b.patches.size());
  for (std::size_t k = 0; k < a.patches.size(); ++k)
  {
    expectSameBits(a.patches[k], b.patches[k]);
  }
}
}  // namespace wheel_rail_contact::core
