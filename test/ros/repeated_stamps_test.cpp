// SPDX-License-Identifier: BSD-3-Clause
// Several samples with one stamp, as a simulation with several evaluations per step sends them.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "pairing_helpers.h"

using namespace wheel_rail_contact;

TEST(RepeatedStamps, RepeatedStampFormsAnotherSet)
{
  Pairing pairing(2);
  for (int evaluation = 0; evaluation < 3; ++evaluation)
  {
    pairing.addToBoth({1});
    EXPECT_EQ(pairing.sets.size(), 1U + static_cast<std::size_t>(evaluation));
    EXPECT_TRUE(pairing.isSettled());
  }
  EXPECT_EQ(pairing.counts().paired, 6U);
}

TEST(RepeatedStamps, SamplesOfARepeatedStampAreMatchedInTheirOrder)
{
  StampPairing<std::string> pairing(2, 0, large_capacity);
  std::vector<std::vector<std::string>> sets;
  const std::vector<std::pair<std::size_t, std::string>> arrivals{
      {0, "pose 1"}, {0, "pose 2"}, {1, "load 1"}, {1, "load 2"}};
  for (const auto& [channel, name] : arrivals)
  {
    for (const auto& set : pairing.add(channel, at(1), name))
    {
      sets.push_back(set);
    }
  }
  EXPECT_EQ(sets, (std::vector<std::vector<std::string>>{{"pose 1", "load 1"}, {"pose 2", "load 2"}}));
}

TEST(RepeatedStamps, RepeatedSampleOfOneChannelDoesNotShiftLaterSets)
{
  // The slop is above the sampling interval, so that the stamps alone permit a shift.
  Pairing pairing(2, 0.0015);
  pairing.add(1, {1, 2, 2, 3, 4});
  pairing.add(0, {1, 2, 3, 4});
  EXPECT_EQ(pairing.sets, (Sets{{1, 1}, {2, 2}, {3, 3}, {4, 4}}));
  EXPECT_EQ(pairing.dropped(DropReason::unmatched), 1U);
}

TEST(RepeatedStamps, RepeatedStampsArePairedWithinTheSlop)
{
  Pairing pairing(2, 0.003);
  for (const int t : {100, 100, 110, 110})
  {
    pairing.add(0, {t});
    pairing.add(1, {t + 2});
  }
  EXPECT_EQ(pairing.sets, (Sets{{100, 102}, {100, 102}, {110, 112}, {110, 112}}));
}

TEST(RepeatedStamps, SampleAtTheStampToWhichAnotherChannelWentBackIsNotARepetition)
{
  Pairing pairing(2);
  pairing.addToBoth({10});
  pairing.add(0, {20});
  pairing.add(0, {10});  // time goes back to the last stamp of the other channel
  pairing.add(1, {10});
  EXPECT_EQ(pairing.sets, (Sets{{10, 10}, {10, 10}}));
}
