// SPDX-License-Identifier: BSD-3-Clause
// The load is interpolated at the stamp of the pose (sync/load: interpolate).
#include "ros/evaluation/input_pairing.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "ros/evaluation/contact_input.h"

using namespace wheel_rail_contact;

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
  EXPECT_DOUBLE_EQ(middle.wrench.force.x, 120);
  EXPECT_DOUBLE_EQ(middle.wrench.force.y, 240);
  EXPECT_DOUBLE_EQ(middle.wrench.force.z, 360);
  EXPECT_DOUBLE_EQ(middle.wrench.torque.x, 480);
  EXPECT_DOUBLE_EQ(middle.wrench.torque.y, 600);
  EXPECT_DOUBLE_EQ(middle.wrench.torque.z, 720);
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
  const PreparedInput prepared = InputPreparation(config()).prepare(inputs[0], tf2::BufferCore());
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
