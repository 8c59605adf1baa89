// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_helpers.h"

using namespace wheel_rail_contact;

TEST(LengthParameters, MillimetresAreRefusedWithTheRangeInMetres)
{
  expectRefused({
      {"track: {gauge: 1435}", "track/gauge = 1435", "must be from 0.2 to 3, in metres"},
      {"track: {gauge_depth: 14}", "track/gauge_depth = 14", "from 1e-05 to 0.1, in metres"},
      {"wheelset: {rolling_radius: 460}", "wheelset/rolling_radius = 460", "from 0.05 to 2, in metres"},
      {"wheel: {left: {rolling_radius: 459}}", "wheel/left/rolling_radius = 459", "in metres"},
      {"wheelset: {flange_back_distance: 1360}", "wheelset/flange_back_distance = 1360", "in metres"},
      {"wheelset: {tape_circle: 70}", "wheelset/tape_circle = 70", "from 0.005 to 0.5, in metres"},
  });
}

TEST(LengthParameters, DimensionsOfNarrowAndBroadGaugeAndOfModelsAreAccepted)
{
  for (const char* yaml : {"{track: {gauge: 0.6}, wheelset: {flange_back_distance: 0.54, rolling_radius: 0.15}}",
                           "{track: {gauge: 1.676}, wheelset: {flange_back_distance: 1.6, rolling_radius: 0.7}}",
                           "{track: {gauge: 0.287}, wheelset: {flange_back_distance: 0.272, rolling_radius: 0.092}}"})
  {
    EXPECT_EQ(refusal(with(yaml)), "accepted");
  }
}
