// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "ros/evaluation/contact_evaluator.h"

using namespace wheel_rail_contact;

namespace
{
core::WheelsetResult withForces(double left_lateral, double left_vertical, double right_lateral, double right_vertical)
{
  core::WheelsetResult result;
  result.rail.left.lateral_force = left_lateral;
  result.rail.left.vertical_force = left_vertical;
  result.rail.right.lateral_force = right_lateral;
  result.rail.right.vertical_force = right_vertical;
  return result;
}
}  // namespace

TEST(LinearRange, NoWarningWithinTheRange)
{
  EXPECT_EQ(linearRangeWarning(withForces(60e3, 100e3, -59e3, 100e3), 0.6), "");
  EXPECT_EQ(linearRangeWarning(withForces(0, 0, 0, 0), 0.6), "") << "wheels without a load";
  EXPECT_EQ(linearRangeWarning(withForces(9e5, 1e5, 0, 0), std::numeric_limits<double>::infinity()), "")
      << "infinite range";
}

TEST(LinearRange, WarningGivesTheForcesOfTheRail)
{
  EXPECT_EQ(linearRangeWarning(withForces(0, 100e3, -70e3, 80e3), 0.6),
            "right rail: Y = -70.0 kN at Q = 80.0 kN, |Y|/Q = 0.875; its compliance table is valid up to 0.6");
}

TEST(LinearRange, WarningListsBothRails)
{
  EXPECT_EQ(linearRangeWarning(withForces(50e3, 40e3, 5e3, 0), 0.6),
            "left rail: Y = 50.0 kN at Q = 40.0 kN, |Y|/Q = 1.250; its compliance table is valid up to 0.6; "
            "right rail: Y = 5.0 kN at Q = 0.0 kN, |Y|/Q = inf; its compliance table is valid up to 0.6");
}

TEST(LinearRange, EachRailHasThatOfItsTable)
{
  const core::WheelsetResult result = withForces(50e3, 100e3, 50e3, 100e3);
  EXPECT_EQ(linearRangeWarning(result, {0.6, 0.4}),
            "right rail: Y = 50.0 kN at Q = 100.0 kN, |Y|/Q = 0.500; its compliance table is valid up to 0.4");
  EXPECT_EQ(linearRangeWarning(result, {0.4, 0.6}),
            "left rail: Y = 50.0 kN at Q = 100.0 kN, |Y|/Q = 0.500; its compliance table is valid up to 0.4");
}
