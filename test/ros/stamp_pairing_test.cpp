// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/stamp_pairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "pairing_helpers.h"

using namespace wheel_rail_contact;

TEST(StampPairing, EqualStampsArePairedInOrder)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  for (const int t : {1, 2, 3})
  {
    add(pairing, 0, t, sets);
  }
  for (const int t : {1, 2, 3})
  {
    add(pairing, 1, t, sets);
  }
  EXPECT_EQ(sets, (Sets{{1, 1}, {2, 2}, {3, 3}}));
  EXPECT_EQ(pairing.counts().paired, 6U);
  expectNothingLost(pairing);
}

TEST(StampPairing, WithoutSlopADifferenceOfOneNanosecondIsNotPaired)
{
  Pairing pairing(2, 0, large_capacity);
  EXPECT_TRUE(pairing.add(0, ros::Time(10, 0), 0).empty());
  EXPECT_TRUE(pairing.add(1, ros::Time(10, 1), 0).empty());
  EXPECT_EQ(dropped(pairing, DropReason::unmatched), 1U) << "the older sample can no longer be matched";
}

TEST(StampPairing, UnmatchedSampleIsDroppedAndCounted)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  for (const int t : {1, 2, 3})
  {
    add(pairing, 0, t, sets);
  }
  for (const int t : {1, 3})
  {
    add(pairing, 1, t, sets);
  }
  EXPECT_EQ(sets, (Sets{{1, 1}, {3, 3}}));
  EXPECT_EQ(dropped(pairing, DropReason::unmatched), 1U);
  expectNothingLost(pairing);
}

TEST(StampPairing, StampsArePairedOnlyWithinTheSlop)
{
  Pairing pairing(2, 0.003, large_capacity);
  Sets sets;
  for (const int t : {100, 200, 300})
  {
    add(pairing, 0, t, sets);
  }
  for (const int t : {97, 203, 304})
  {
    add(pairing, 1, t, sets);
  }
  EXPECT_EQ(sets, (Sets{{100, 97}, {200, 203}}));
  EXPECT_EQ(dropped(pairing, DropReason::unmatched), 1U);
  EXPECT_EQ(pairing.counts().waiting, 1U);
}

TEST(StampPairing, FastAndSlowChannelsArePaired)
{
  Pairing pairing(2, 0.0004, large_capacity);
  Sets sets;
  for (int t = 20; t <= 120; ++t)
  {
    add(pairing, 0, t, sets);
    if (t % 20 == 0)
    {
      add(pairing, 1, t, sets);
    }
  }
  EXPECT_EQ(sets, (Sets{{20, 20}, {40, 40}, {60, 60}, {80, 80}, {100, 100}, {120, 120}}));
  EXPECT_EQ(dropped(pairing, DropReason::unmatched), 95U);
  expectNothingLost(pairing);
}

TEST(StampPairing, SetOfFourChannelsNeedsASampleOfEach)
{
  Pairing pairing(4, 0, large_capacity);
  Sets sets;
  for (const std::size_t channel : {2U, 0U, 3U})
  {
    add(pairing, channel, 5, sets);
  }
  EXPECT_TRUE(sets.empty());
  add(pairing, 1, 5, sets);
  EXPECT_EQ(sets, (Sets{{5, 5, 5, 5}}));
}

TEST(StampPairing, EachSampleOfASingleChannelIsASet)
{
  Pairing pairing(1, 0, large_capacity);
  Sets sets;
  add(pairing, 0, 7, sets);
  EXPECT_EQ(sets, (Sets{{7}}));
}

TEST(StampPairing, SetsDoNotDependOnTheOrderOfArrival)
{
  const unsigned seed = 20111U;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::array<std::vector<int>, 2> stamps;
  for (auto& channel : stamps)
  {
    for (int t = 1; t < 400; t += static_cast<int>(random() % 7))
    {
      channel.push_back(t);  // one in seven stamps is repeated
    }
  }
  Sets first;
  for (int trial = 0; trial < 50; ++trial)
  {
    Pairing pairing(2, 0.002, large_capacity);
    Sets sets;
    std::array<std::size_t, 2> next{};
    while (next[0] < stamps[0].size() || next[1] < stamps[1].size())
    {
      const std::size_t drawn = random() % 2;
      const std::size_t channel = next[drawn] < stamps[drawn].size() ? drawn : 1 - drawn;
      add(pairing, channel, stamps[channel][next[channel]++], sets);
    }
    expectNothingLost(pairing);
    if (trial == 0)
    {
      first = sets;
    }
    ASSERT_EQ(sets, first);
  }
  EXPECT_GT(first.size(), 50U);
}

TEST(StampPairing, FullQueueKeepsTheNewest)
{
  Pairing pairing(2, 0, 3);
  Sets sets;
  for (const int t : {1, 2, 3, 4, 5})
  {
    add(pairing, 0, t, sets);
  }
  EXPECT_EQ(pairing.counts().waiting, 3U);
  for (const int t : {3, 4, 5})
  {
    add(pairing, 1, t, sets);
  }
  EXPECT_EQ(sets, (Sets{{3, 3}, {4, 4}, {5, 5}}));
  EXPECT_EQ(dropped(pairing, DropReason::queue_full), 2U);
  expectNothingLost(pairing);
}

TEST(StampPairing, BagLoopLosesOnlyWaitingSamples)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  for (int loop = 0; loop < 3; ++loop)
  {
    for (const int t : {1, 2, 3})
    {
      add(pairing, 0, t, sets);
      add(pairing, 1, t, sets);
    }
    add(pairing, 1, 4, sets);  // the bag has no pose with this stamp
  }
  EXPECT_EQ(sets.size(), 9U);
  EXPECT_EQ(dropped(pairing, DropReason::time_jump), 2U);
  EXPECT_EQ(pairing.counts().waiting, 1U);
  expectNothingLost(pairing);
}

TEST(StampPairing, NewPosesWaitForLoadsThatGoBackLater)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  for (const int t : {1, 2, 3})
  {
    add(pairing, 0, t, sets);
    add(pairing, 1, t, sets);
  }
  for (const int t : {1, 2, 3})
  {
    add(pairing, 0, t, sets);
  }
  for (const int t : {1, 2, 3})
  {
    add(pairing, 1, t, sets);
  }
  EXPECT_EQ(sets.size(), 6U);
  expectNothingLost(pairing);
}

TEST(StampPairing, BagLoopLosesNoSetInAnyOrderOfArrival)
{
  const unsigned seed = 20112U;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  constexpr std::size_t loops = 5, samples = 20, channels = 3;
  for (int trial = 0; trial < 100; ++trial)
  {
    Pairing pairing(channels, 0, large_capacity);
    Sets sets;
    std::array<std::size_t, channels> sent{};
    while (sets.size() < loops * samples && *std::min_element(sent.begin(), sent.end()) < loops * samples)
    {
      // No channel is a whole loop ahead of another, because the loops could not be distinguished then.
      const std::size_t channel = random() % channels;
      const std::size_t slowest = *std::min_element(sent.begin(), sent.end());
      if (sent[channel] < std::min(loops * samples, slowest + samples - 1))
      {
        add(pairing, channel, 10 * static_cast<int>(1 + sent[channel] % samples), sets);
        ++sent[channel];
      }
    }
    ASSERT_EQ(sets.size(), loops * samples);
    for (std::size_t i = 0; i < sets.size(); ++i)
    {
      ASSERT_EQ(sets[i], std::vector<int>(channels, 10 * static_cast<int>(1 + i % samples)));
    }
    EXPECT_EQ(pairing.counts().waiting, 0U);
    expectNothingLost(pairing);
  }
}

TEST(StampPairing, LateLoadIsPairedAfterThePosesHaveGoneBack)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  add(pairing, 0, 50, sets);
  add(pairing, 1, 50, sets);
  add(pairing, 0, 60, sets);
  add(pairing, 0, 10, sets);
  add(pairing, 1, 60, sets);
  add(pairing, 1, 10, sets);
  EXPECT_EQ(sets, (Sets{{50, 50}, {60, 60}, {10, 10}}));
  expectNothingLost(pairing);
}

TEST(StampPairing, ChannelThatHasNotPassedTheNewTimeNeedNotGoBack)
{
  Pairing pairing(3, 0, large_capacity);
  Sets sets;
  for (const int t : {60, 70, 80})
  {
    add(pairing, 0, t, sets);
    add(pairing, 1, t, sets);  // the third channel has no samples yet
  }
  for (const int t : {10, 20})
  {
    add(pairing, 0, t, sets);
    add(pairing, 2, t, sets);
    add(pairing, 1, t, sets);
  }
  EXPECT_EQ(sets, (Sets{{10, 10, 10}, {20, 20, 20}}));
  EXPECT_EQ(dropped(pairing, DropReason::time_jump), 6U);
  expectNothingLost(pairing);
}

TEST(StampPairing, SampleOutOfOrderAtTheEndOfALoopAffectsOnlyItsNeighbours)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  for (int loop = 0; loop < 4; ++loop)
  {
    for (const int t : {10, 20, 30, 40, 50, 45})
    {
      add(pairing, 0, t, sets);
      add(pairing, 1, t == 45 ? 60 : t, sets);
    }
  }
  EXPECT_GE(sets.size(), 4U * 4U);
  for (const auto& set : sets)
  {
    EXPECT_EQ(set[0], set[1]);
  }
  expectNothingLost(pairing);
}

TEST(StampPairing, LoadFromBeforeAJumpIsNotPairedWithALaterPose)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  add(pairing, 0, 60, sets);
  add(pairing, 1, 61, sets);
  add(pairing, 0, 10, sets);  // time goes back: the load at 61 is from before the jump
  add(pairing, 0, 61, sets);
  EXPECT_TRUE(sets.empty());
  EXPECT_EQ(dropped(pairing, DropReason::time_jump), 2U) << "the samples on both sides of the jump";
  expectNothingLost(pairing);
}

TEST(StampPairing, SampleOutOfOrderDoesNotBlockLaterSamples)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  for (const int t : {10, 20, 15, 30, 40, 50})
  {
    add(pairing, 0, t, sets);
    add(pairing, 1, t == 15 ? 25 : t, sets);
  }
  EXPECT_EQ(sets, (Sets{{10, 10}, {20, 20}, {30, 30}, {40, 40}, {50, 50}}));
  expectNothingLost(pairing);
}

TEST(StampPairing, SmallestAndLargestStampsCauseNoOverflow)
{
  Pairing pairing(2, 1.0, large_capacity);
  const ros::Time last(std::numeric_limits<std::uint32_t>::max(), 999999999);
  EXPECT_TRUE(pairing.add(0, ros::Time(0, 1), 0).empty());
  EXPECT_TRUE(pairing.add(1, last, 0).empty());
  EXPECT_FALSE(pairing.add(0, last, 0).empty());
  EXPECT_TRUE(pairing.add(0, ros::Time(5, 0), 0).empty());
  EXPECT_FALSE(pairing.add(1, ros::Time(5, 0), 0).empty());
  expectNothingLost(pairing);
}

TEST(StampPairing, FinishDropsAndCountsWaitingSamples)
{
  Pairing pairing(2, 0, large_capacity);
  Sets sets;
  add(pairing, 0, 1, sets);
  pairing.finish();
  EXPECT_EQ(pairing.counts().waiting, 0U);
  EXPECT_EQ(dropped(pairing, DropReason::unmatched), 1U);
  expectNothingLost(pairing);
}
