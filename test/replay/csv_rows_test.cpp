// SPDX-License-Identifier: BSD-3-Clause
#include "replay/csv_rows.h"

#include <gtest/gtest.h>

using namespace wheel_rail_contact;

TEST(CsvRows, HeldAndImplausibleResultsAreMarkedBesideTheReason)
{
  WheelsetContact result;
  result.header.stamp.sec = 2;
  result.status_text = "a reason";
  EXPECT_EQ(csvRows(result, 7, "front").substr(0, 42), "7,front,2.000000000,OK,\"a reason\",0,0,0,0,");
  result.implausible_force = true;
  EXPECT_EQ(csvRows(result, 7, "front").substr(0, 42), "7,front,2.000000000,OK,\"a reason\",0,1,0,0,");
  result.held = true;
  EXPECT_EQ(csvRows(result, 7, "front").substr(0, 42), "7,front,2.000000000,OK,\"a reason\",1,1,0,0,");
}
