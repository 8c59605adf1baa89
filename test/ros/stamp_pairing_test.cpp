// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/stamp_pairing.h"

#include "../seeded.h"
#include "pairing_helpers.h"

using namespace wheel_rail_contact;

TEST(StampPairing, SamplesArePairedWithinTheSlopAndOthersAreCounted)
{
  const PairingCase cases[] = {
      {"in step", 2, "a1,2,3 b1,2,3", "1/1 2/2 3/3"},
      {"one is missing", 2, "a1,2,3 b1,3", "1/1 3/3", "unmatched 1"},
      {"within the slop", 2, "a100,200,300 b97,203,304", "100/97 200/203", "unmatched 1 waiting 1", 0.003},
      {"incomplete", 4, "c5 a5 d5", "", "waiting 3"},
      {"complete", 4, "c5 a5 d5 b5", "5/5/5/5"},
      {"one channel", 1, "a7", "7"},
      // A slop above the sampling interval would permit a shift.
      {"a repeated sample does not shift later sets", 2, "b1,2,2,3,4 a1,2,3,4", "1/1 2/2 3/3 4/4", "unmatched 1",
       0.0015},
      {"a full queue keeps the newest", 2, "a1,2,3,4,5 b3,4,5", "3/3 4/4 5/5", "full 2", 0, 3},
      {"a bag without a pose at 4, in a loop", 2, "ab1,2,3 b4 ab1,2,3 b4 ab1,2,3 b4",
       "1/1 2/2 3/3 1/1 2/2 3/3 1/1 2/2 3/3", "jump 2 waiting 1"},
      {"a channel that has not passed the new time need not go back", 3, "ab60,70,80 acb10,20", "10/10/10 20/20/20",
       "jump 6"},
      {"the load at 61 is from before the jump, the pose after it", 2, "ab50,60 b61 a10,20,61", "50/50 60/60",
       "jump 1 waiting 3"},
      {"and the loads follow", 2, "ab50,60 b61 a10,20,61 b10,20,61", "50/50 60/60 10/10 20/20 61/61", "jump 1"},
      {"a far stamp in place of 3 costs one sample", 2, "ab1,2 b3,4,5 a2000000000,4,5 ab6", "1/1 2/2 4/4 5/5 6/6",
       "unmatched 1 jump 1"},
      {"samples out of order do not block later ones", 2, "ab10,20 a15 b25 ab30,40,50", "10/10 20/20 30/30 40/40 50/50",
       "unmatched 1 jump 1"},
      // Several samples with one stamp, as a simulation with several evaluations per step sends them.
      {"a repeated stamp forms another set", 2, "ab1,1,1", "1/1 1/1 1/1"},
      {"within the slop, too", 2, "a100 b102 a100 b102 a110 b112 a110 b112", "100/102 100/102 110/112 110/112", "",
       0.003},
      {"a stamp to which another channel went back is no repetition", 2, "ab10 a20,10 b10", "10/10 10/10", "jump 1"}};
  for (const PairingCase& one : cases)
  {
    expectPaired(one);
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
