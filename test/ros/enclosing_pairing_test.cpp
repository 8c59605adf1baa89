// SPDX-License-Identifier: BSD-3-Clause
// StampPairing with a last channel that encloses the others, as for loads that are interpolated.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "pairing_helpers.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double longest_gap = 0.02;  ///< [s]
constexpr int poses = 0, loads = 1;   ///< channels

/// Sets that belong to two sequences of increasing stamps, by their definition.
Sets enclosedSets(const Stamps& pose_stamps, const Stamps& load_stamps)
{
  Sets sets;
  for (const int pose : pose_stamps)
  {
    const auto next = std::lower_bound(load_stamps.begin(), load_stamps.end(), pose);
    if (next != load_stamps.end() && *next == pose)
    {
      sets.push_back({pose, pose, pose});
    }
    else if (next != load_stamps.end() && next != load_stamps.begin() && *next - *(next - 1) <= 1e3 * longest_gap)
    {
      sets.push_back({pose, *(next - 1), *next});
    }
  }
  return sets;
}

Stamps randomStamps(std::mt19937& random, int longest_step)
{
  Stamps stamps;
  for (int t = 1; t < 500; t += 1 + static_cast<int>(random() % static_cast<unsigned>(longest_step)))
  {
    stamps.push_back(t);
  }
  return stamps;
}
}  // namespace

TEST(EnclosingPairing, SlowLoadCompletesAllPosesSinceTheLoadBefore)
{
  Pairing pairing(2, 0, large_capacity, longest_gap);
  EXPECT_EQ(pairing.add(loads, {10}), Sets{});
  EXPECT_EQ(pairing.add(poses, {12, 16, 20, 24}), Sets{}) << "a pose waits for the next load";
  EXPECT_EQ(pairing.add(loads, {20}), (Sets{{12, 10, 20}, {16, 10, 20}, {20, 20, 20}}));
  EXPECT_FALSE(pairing.isSettled());
  EXPECT_EQ(pairing.add(loads, {30}), (Sets{{24, 20, 30}}));
  EXPECT_TRUE(pairing.isSettled());
  pairing.finish();
  EXPECT_EQ(pairing.counts().paired, 7U);
}

TEST(EnclosingPairing, PoseWithTheStampOfALoadNeedsNoOtherLoad)
{
  Pairing pairing(2, 0, large_capacity, longest_gap);
  EXPECT_EQ(pairing.add(loads, {100}), Sets{});
  EXPECT_EQ(pairing.add(poses, {100}), (Sets{{100, 100, 100}}));
  EXPECT_EQ(pairing.add(loads, {900}), Sets{});
  EXPECT_EQ(pairing.add(poses, {900}), (Sets{{900, 900, 900}})) << "the gap does not matter";
}

TEST(EnclosingPairing, PosesBeforeTheFirstAndAfterTheLastLoadAreDroppedAndCounted)
{
  Pairing pairing(2, 0, large_capacity, longest_gap);
  pairing.add(poses, {10, 15, 22, 31, 40});
  EXPECT_EQ(pairing.add(loads, {20, 30}), (Sets{{22, 20, 30}}));
  EXPECT_EQ(pairing.counts()[DropReason::not_enclosed], 2U);
  pairing.finish();
  EXPECT_EQ(pairing.counts()[DropReason::not_enclosed], 4U);
  EXPECT_EQ(pairing.dropped(poses), 4U);
  EXPECT_EQ(pairing.counts().waiting, 0U);
}

TEST(EnclosingPairing, PosesInALongerGapThanAllowedAreDroppedAndCounted)
{
  Pairing pairing(2, 0, large_capacity, longest_gap);
  pairing.add(poses, {11, 12, 33, 55, 75});
  EXPECT_EQ(pairing.add(loads, {10, 30, 51, 71, 80}), (Sets{{11, 10, 30}, {12, 10, 30}, {55, 51, 71}, {75, 71, 80}}));
  EXPECT_EQ(pairing.counts()[DropReason::not_enclosed], 1U) << "33 is between 30 and 51";
}

TEST(EnclosingPairing, LoadsBetweenTwoPosesAreNotNeeded)
{
  Pairing pairing(2, 0, large_capacity, longest_gap);
  pairing.add(poses, {15, 45});
  EXPECT_EQ(pairing.add(loads, {10, 20, 30, 40, 50, 60}), (Sets{{15, 10, 20}, {45, 40, 50}}));
  pairing.finish();
  EXPECT_EQ(pairing.counts()[DropReason::unneeded], 2U) << "30 and 60";
  EXPECT_EQ(pairing.counts().paired, 6U);
}

TEST(EnclosingPairing, OtherChannelsAreMatchedByTheirStamps)
{
  Pairing pairing(3, 0.002, large_capacity, longest_gap);
  pairing.add(0, {12, 16, 24});
  pairing.add(2, {10, 20, 30});
  EXPECT_EQ(pairing.add(1, {13, 18, 27}), (Sets{{12, 13, 10, 20}, {16, 18, 10, 20}}))
      << "the stamp of the first channel is enclosed";
  pairing.finish();
  EXPECT_EQ(pairing.counts()[DropReason::unmatched], 2U) << "24 and 27";
}

TEST(EnclosingPairing, SetsDependOnlyOnTheSequenceOfEachChannel)
{
  std::mt19937 random(1);  // seed 1
  for (int trial = 0; trial < 200; ++trial)
  {
    const std::vector<Stamps> stamps{randomStamps(random, 12), randomStamps(random, 25)};
    Pairing pairing(2, 0, large_capacity, longest_gap);
    std::size_t next[] = {0, 0};
    while (next[poses] < stamps[poses].size() || next[loads] < stamps[loads].size())
    {
      const std::size_t channel = next[poses] == stamps[poses].size()   ? loads
                                  : next[loads] == stamps[loads].size() ? poses
                                                                        : random() % 2;
      pairing.add(channel, {stamps[channel][next[channel]++]});
    }
    ASSERT_EQ(pairing.sets, enclosedSets(stamps[poses], stamps[loads])) << "trial " << trial;
    pairing.finish();
    EXPECT_EQ(pairing.dropped(poses), stamps[poses].size() - pairing.sets.size());
  }
}

// A bag that loops: the stamps of one topic go back before those of the other one.
TEST(EnclosingPairing, NoSetCombinesSamplesFromBeforeAndAfterAJumpOfTime)
{
  for (const std::size_t first : {poses, loads})
  {
    const std::size_t second = 1 - first;
    const Stamps ends[] = {{52, 58, 63}, {50, 60}}, starts[] = {{11, 18, 23}, {10, 20}};
    Pairing pairing(2, 0, large_capacity, longest_gap);
    pairing.add(poses, {41});
    pairing.add(loads, {40});
    for (const std::size_t channel : {first, second})
    {
      pairing.add(channel, ends[channel]);
      pairing.add(channel, starts[channel]);
    }
    pairing.add(loads, {30});
    EXPECT_EQ(pairing.sets, (Sets{{41, 40, 50}, {52, 50, 60}, {58, 50, 60}, {11, 10, 20}, {18, 10, 20}, {23, 20, 30}}))
        << "channel " << first << " goes back first";
    EXPECT_EQ(pairing.counts()[DropReason::time_jump], 1U) << "63 is after the last load before the jump";
  }
}

TEST(EnclosingPairing, WaitingSamplesAreLimitedByTheCapacity)
{
  Pairing pairing(2, 0, 3, longest_gap);
  pairing.add(loads, {10, 20, 30, 40});
  EXPECT_EQ(pairing.counts()[DropReason::queue_full], 1U);
  EXPECT_EQ(pairing.add(poses, {12, 22}), (Sets{{22, 20, 30}})) << "the load before 12 was dropped";
  pairing.add(poses, {41, 42, 43, 44});
  EXPECT_EQ(pairing.counts()[DropReason::queue_full], 2U);
  EXPECT_EQ(pairing.add(loads, {50}), (Sets{{42, 40, 50}, {43, 40, 50}, {44, 40, 50}}));
}

TEST(EnclosingPairing, RepeatedPosesHaveTheSameLoads)
{
  Pairing pairing(2, 0, large_capacity, longest_gap);
  pairing.add(loads, {10, 20});
  EXPECT_EQ(pairing.add(poses, {15, 15, 20, 20}), (Sets{{15, 10, 20}, {15, 10, 20}, {20, 20, 20}, {20, 20, 20}}));
}

TEST(EnclosingPairing, SecondLoadOfAStampIsDroppedAsADuplicate)
{
  StampPairing<std::string> pairing(2, 0, large_capacity, longest_gap);
  const ros::Time stamp(1, 0);
  EXPECT_TRUE(pairing.add(loads, stamp, "first").empty());
  EXPECT_TRUE(pairing.add(loads, stamp, "second").empty());
  const auto sets = pairing.add(poses, stamp, "pose");
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0], (std::vector<std::string>{"pose", "first", "first"}));
  EXPECT_EQ(pairing.counts()[DropReason::duplicate], 1U);
}
