// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/stamp_pairing.h"

#include "../seeded.h"
#include "pairing_helpers.h"

using namespace wheel_rail_contact;

TEST(StampPairing, SamplesArePairedWithinTheSlopAndOthersAreCounted)
{
  struct Sequence
  {
    std::size_t channels;
    double slop;
    std::vector<std::pair<std::size_t, Stamps>> samples;
    Sets sets;
    std::uint64_t unmatched = 0, waiting = 0;
  };
  const Sequence sequences[] = {
      {2, 0, {{0, {1, 2, 3}}, {1, {1, 2, 3}}}, {{1, 1}, {2, 2}, {3, 3}}},
      {2, 0, {{0, {1, 2, 3}}, {1, {1, 3}}}, {{1, 1}, {3, 3}}, 1},
      {2, 0.003, {{0, {100, 200, 300}}, {1, {97, 203, 304}}}, {{100, 97}, {200, 203}}, 1, 1},
      {4, 0, {{2, {5}}, {0, {5}}, {3, {5}}}, {}, 0, 3},
      {4, 0, {{2, {5}}, {0, {5}}, {3, {5}}, {1, {5}}}, {{5, 5, 5, 5}}},
      {1, 0, {{0, {7}}}, {{7}}},
      // A repeated sample does not shift later sets, where a slop above the sampling interval permits a shift.
      {2, 0.0015, {{1, {1, 2, 2, 3, 4}}, {0, {1, 2, 3, 4}}}, {{1, 1}, {2, 2}, {3, 3}, {4, 4}}, 1}};
  for (const Sequence& sequence : sequences)
  {
    Pairing pairing(sequence.channels, sequence.slop);
    for (const auto& [channel, stamps] : sequence.samples)
    {
      pairing.add(channel, stamps);
    }
    EXPECT_EQ(pairing.sets, sequence.sets);
    EXPECT_EQ(pairing.counts().paired, sequence.channels * sequence.sets.size());
    EXPECT_EQ(pairing.dropped(DropReason::unmatched), sequence.unmatched);
    EXPECT_EQ(pairing.counts().waiting, sequence.waiting);
  }
}

TEST(StampPairing, WithoutSlopADifferenceOfOneNanosecondIsNotPaired)
{
  Pairing pairing(2);
  EXPECT_TRUE(pairing.add(0, ros::Time(10, 0), 0).empty());
  EXPECT_TRUE(pairing.add(1, ros::Time(10, 1), 0).empty());
  EXPECT_EQ(pairing.dropped(DropReason::unmatched), 1U) << "the older sample can no longer be matched";
}

TEST(StampPairing, FastAndSlowChannelsArePaired)
{
  Pairing pairing(2, 0.0004);
  for (int t = 20; t <= 120; ++t)
  {
    pairing.add(0, {t});
    if (t % 20 == 0)
    {
      pairing.add(1, {t});
    }
  }
  EXPECT_EQ(pairing.sets, (Sets{{20, 20}, {40, 40}, {60, 60}, {80, 80}, {100, 100}, {120, 120}}));
  EXPECT_EQ(pairing.dropped(DropReason::unmatched), 95U);
}

TEST(StampPairing, SetsDoNotDependOnTheOrderOfArrival)
{
  core::Seeded random(20111U);
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
    Pairing pairing(2, 0.002);
    std::array<std::size_t, 2> next{};
    while (next[0] < stamps[0].size() || next[1] < stamps[1].size())
    {
      const std::size_t drawn = random() % 2;
      const std::size_t channel = next[drawn] < stamps[drawn].size() ? drawn : 1 - drawn;
      pairing.add(channel, {stamps[channel][next[channel]++]});
    }
    if (trial == 0)
    {
      first = pairing.sets;
    }
    ASSERT_EQ(pairing.sets, first);
  }
  EXPECT_GT(first.size(), 50U);
}

TEST(StampPairing, FullQueueKeepsTheNewest)
{
  Pairing pairing(2, 0, 3);
  pairing.add(0, {1, 2, 3, 4, 5});
  EXPECT_EQ(pairing.counts().waiting, 3U);
  pairing.add(1, {3, 4, 5});
  EXPECT_EQ(pairing.sets, (Sets{{3, 3}, {4, 4}, {5, 5}}));
  EXPECT_EQ(pairing.dropped(DropReason::queue_full), 2U);
}

TEST(StampPairing, BagLoopLosesOnlyWaitingSamples)
{
  Pairing pairing(2);
  for (int loop = 0; loop < 3; ++loop)
  {
    pairing.addToBoth({1, 2, 3});
    pairing.add(1, {4});  // the bag has no pose with this stamp
  }
  EXPECT_EQ(pairing.sets.size(), 9U);
  EXPECT_EQ(pairing.dropped(DropReason::time_jump), 2U);
  EXPECT_EQ(pairing.counts().waiting, 1U);
}

TEST(StampPairing, ChannelThatHasNotPassedTheNewTimeNeedNotGoBack)
{
  Pairing pairing(3);
  for (const int t : {60, 70, 80})
  {
    pairing.add(0, {t});
    pairing.add(1, {t});  // the third channel has no samples yet
  }
  for (const int t : {10, 20})
  {
    pairing.add(0, {t});
    pairing.add(2, {t});
    pairing.add(1, {t});
  }
  EXPECT_EQ(pairing.sets, (Sets{{10, 10, 10}, {20, 20, 20}}));
  EXPECT_EQ(pairing.dropped(DropReason::time_jump), 6U);
}

TEST(StampPairing, SampleOutOfOrderAtTheEndOfALoopAffectsOnlyItsNeighbours)
{
  Pairing pairing(2);
  for (int loop = 0; loop < 4; ++loop)
  {
    for (const int t : {10, 20, 30, 40, 50, 45})
    {
      pairing.add(0, {t});
      pairing.add(1, {t == 45 ? 60 : t});
    }
  }
  EXPECT_GE(pairing.sets.size(), 4U * 4U);
  for (const auto& set : pairing.sets)
  {
    EXPECT_EQ(set[0], set[1]);
  }
}

TEST(StampPairing, LoadFromBeforeAJumpIsNotPairedWithALaterPose)
{
  Pairing pairing(2);
  pairing.addToBoth({50, 60});
  pairing.add(1, {61});
  pairing.add(0, {10, 20, 61});  // time goes back: the load at 61 is from before the jump
  EXPECT_EQ(pairing.sets, (Sets{{50, 50}, {60, 60}}));
  EXPECT_EQ(pairing.dropped(DropReason::time_jump), 1U);
  pairing.add(1, {10, 20, 61});
  EXPECT_EQ(pairing.sets, (Sets{{50, 50}, {60, 60}, {10, 10}, {20, 20}, {61, 61}}));
}

TEST(StampPairing, FarStampOfOneChannelCostsOneSample)
{
  Pairing pairing(2);
  pairing.addToBoth({1, 2});
  pairing.add(1, {3, 4, 5});
  pairing.add(0, {2000000000, 4, 5});  // instead of 3
  pairing.addToBoth({6});
  EXPECT_EQ(pairing.sets, (Sets{{1, 1}, {2, 2}, {4, 4}, {5, 5}, {6, 6}}));
  EXPECT_EQ(pairing.counts().waiting, 0U);
}

TEST(StampPairing, SampleOutOfOrderDoesNotBlockLaterSamples)
{
  Pairing pairing(2);
  for (const int t : {10, 20, 15, 30, 40, 50})
  {
    pairing.add(0, {t});
    pairing.add(1, {t == 15 ? 25 : t});
  }
  EXPECT_EQ(pairing.sets, (Sets{{10, 10}, {20, 20}, {30, 30}, {40, 40}, {50, 50}}));
}

TEST(StampPairing, SmallestAndLargestStampsCauseNoOverflow)
{
  Pairing pairing(2, 1.0);
  const ros::Time last(std::numeric_limits<std::uint32_t>::max(), 999999999);
  EXPECT_TRUE(pairing.add(0, ros::Time(0, 1), 0).empty());
  EXPECT_TRUE(pairing.add(1, last, 0).empty());
  EXPECT_FALSE(pairing.add(0, last, 0).empty());
  EXPECT_TRUE(pairing.add(0, ros::Time(5, 0), 0).empty());
  EXPECT_FALSE(pairing.add(1, ros::Time(5, 0), 0).empty());
}

TEST(StampPairing, FinishDropsAndCountsWaitingSamples)
{
  Pairing pairing(2);
  pairing.add(0, {1});
  pairing.finish();
  EXPECT_EQ(pairing.counts().waiting, 0U);
  EXPECT_EQ(pairing.dropped(DropReason::unmatched), 1U);
}

// Several samples with one stamp, as a simulation with several evaluations per step sends them.

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
