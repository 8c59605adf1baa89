// SPDX-License-Identifier: BSD-3-Clause
#include <boost/make_shared.hpp>
#include <tuple>

#include "../usual_headers.h"
#include "pairing_helpers.h"
#include "ros/evaluation/contact_input.h"
#include "ros/evaluation/input_pairing.h"

using namespace wheel_rail_contact;

// StampPairing with a last channel that encloses the others, as for loads that are interpolated.
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

TEST(EnclosingPairing, PosesBetweenTwoLoadsArePairedAndOthersAreCounted)
{
  const PairingCase cases[] = {
      {"a pose with the stamp of a load needs no other one", 2, "b100 a100", "100/100/100"},
      {"a gap before it does not matter", 2, "b100 a100 b900 a900", "100/100/100 900/900/900"},
      {"before the first and after the last load", 2, "a10,15,22,31,40 b20,30", "22/20/30", "outside 2 waiting 3"},
      {"33 is in a longer gap than allowed", 2, "a11,12,33,55,75 b10,30,51,71,80",
       "11/10/30 12/10/30 55/51/71 75/71/80", "outside 1"},
      {"a load between two poses is not needed", 2, "a15,45 b10,20,30,40,50,60", "15/10/20 45/40/50", "unneeded 1"},
      {"other channels are matched by their stamps", 3, "a12,16,24 c10,20,30 b13,18,27", "12/13/10/20 16/18/10/20",
       "unmatched 1 waiting 4", 0.002},
      {"repeated poses have the same loads", 2, "b10,20 a15,15,20,20", "15/10/20 15/10/20 20/20/20 20/20/20"}};
  for (const PairingCase& one : cases)
  {
    expectPaired(one, longest_gap);
  }
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

// The load is interpolated at the stamp of the pose (sync/load: interpolate).
namespace
{
geometry_msgs::WrenchStamped load(double stamp, double value, const std::string& frame = "track")
{
  geometry_msgs::WrenchStamped message;
  message.header.stamp = ros::Time(stamp);
  message.header.frame_id = frame;
  geometry_msgs::Vector3 &force = message.wrench.force, &torque = message.wrench.torque;
  double factor = 1;
  for (double* component : {&force.x, &force.y, &force.z, &torque.x, &torque.y, &torque.z})
  {
    *component = value * factor++;
  }
  return message;
}

class LoadInterpolation : public testing::Test
{
 protected:
  LoadInterpolation() : pairing_(config()) {}

  static NodeConfig config()
  {
    NodeConfig config;
    config.interpolate_load = true;
    config.distance_topic = true;
    config.longest_gap = 0.05;
    return config;
  }

  std::vector<ContactInput> addLoad(const geometry_msgs::WrenchStamped& message)
  {
    return pairing_.add(InputTopic::load,
                        InputMessage(boost::make_shared<const geometry_msgs::WrenchStamped>(message)));
  }

  /// Adds a pose and a distance.
  std::vector<ContactInput> addPose(double stamp)
  {
    const auto pose = boost::make_shared<geometry_msgs::PoseStamped>();
    pose->header.stamp = ros::Time(stamp);
    pose->header.frame_id = "track";
    pose->pose.orientation.w = 1;
    EXPECT_TRUE(pairing_.add(InputTopic::pose, InputMessage(geometry_msgs::PoseStampedConstPtr(pose))).empty());
    const auto distance = boost::make_shared<geometry_msgs::PointStamped>();
    distance->header.stamp = ros::Time(stamp);
    distance->point.x = stamp;
    return pairing_.add(InputTopic::distance, InputMessage(geometry_msgs::PointStampedConstPtr(distance)));
  }

  InputPairing pairing_;
};
}  // namespace

TEST_F(LoadInterpolation, ForceAndMomentAreLinearInTime)
{
  const auto middle = interpolatedLoad(load(10, 100), load(10.04, 180), ros::Time(10.01));
  EXPECT_EQ(middle.header.stamp, ros::Time(10.01));
  EXPECT_EQ(middle.header.frame_id, "track");
  const geometry_msgs::Vector3 &force = middle.wrench.force, &torque = middle.wrench.torque;
  double expected = 0;
  for (const double component : {force.x, force.y, force.z, torque.x, torque.y, torque.z})
  {
    EXPECT_DOUBLE_EQ(component, expected += 120);
  }
}

TEST_F(LoadInterpolation, EveryPoseBetweenTwoLoadsHasItsOwnLoad)
{
  EXPECT_TRUE(addLoad(load(10, 1000)).empty());
  for (const double stamp : {10.0, 10.01, 10.03})
  {
    EXPECT_EQ(addPose(stamp).size(), stamp == 10 ? 1U : 0U) << "a pose between loads waits for the next load";
  }
  const auto inputs = addLoad(load(10.04, 1400));
  ASSERT_EQ(inputs.size(), 2U);
  for (const auto& [input, stamp, force] :
       {std::make_tuple(inputs[0], 10.01, 1100.0), std::make_tuple(inputs[1], 10.03, 1300.0)})
  {
    EXPECT_EQ(input.pose->header.stamp, ros::Time(stamp));
    EXPECT_EQ(input.load->header.stamp, ros::Time(stamp));
    EXPECT_NEAR(input.load->wrench.force.x, force, 1e-9);
    EXPECT_EQ(input.distance->point.x, stamp);
    EXPECT_EQ(input.fault, "");
  }
}

TEST_F(LoadInterpolation, LongestGapIsThatOfTheParameters)
{
  addLoad(load(10, 1));
  addPose(10.01);
  EXPECT_TRUE(addLoad(load(10.051, 1)).empty());
  EXPECT_EQ(pairing_.counts()[DropReason::not_enclosed], 2U) << "pose and distance";
  EXPECT_EQ(pairing_.droppedPoses(), 1U);
  addPose(10.06);
  EXPECT_EQ(addLoad(load(10.101, 1)).size(), 1U);
}

TEST_F(LoadInterpolation, LoadsInDifferentFramesAreRefusedByName)
{
  addLoad(load(10, 1, "track"));
  addPose(10.01);
  const auto inputs = addLoad(load(10.02, 1, "axle"));
  ASSERT_EQ(inputs.size(), 1U);
  const TransformStore transforms;
  const NeighbourForces neighbours(config());
  const PreparedInput prepared = InputPreparation(config(), transforms, neighbours).prepare(inputs[0]);
  EXPECT_EQ(prepared.status, WheelsetContact::INVALID_INPUT);
  EXPECT_EQ(prepared.reason,
            "load: frame_id is 'track' before the pose and 'axle' after it, but must be the same to interpolate");
}

TEST_F(LoadInterpolation, NoLoadIsInterpolatedIfHeightAndRollAreGiven)
{
  NodeConfig given = config();
  given.model.wheelset.solve_height_and_roll = false;
  given.distance_topic = false;
  InputPairing pairing(given);
  const auto pose = boost::make_shared<geometry_msgs::PoseStamped>();
  pose->header.stamp = ros::Time(10);
  const auto inputs = pairing.add(InputTopic::pose, InputMessage(geometry_msgs::PoseStampedConstPtr(pose)));
  ASSERT_EQ(inputs.size(), 1U);
  EXPECT_FALSE(inputs[0].load);
}
