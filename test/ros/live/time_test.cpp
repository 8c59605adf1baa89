// SPDX-License-Identifier: BSD-3-Clause
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include "../../usual_headers.h"
#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
geometry_msgs::TransformStamped shifted(const std::string& frame, double y, const ros::Time& stamp)
{
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "track";
  transform.header.stamp = stamp;
  transform.child_frame_id = frame;
  transform.transform.translation.y = y;
  transform.transform.rotation.w = 1;
  return transform;
}
}  // namespace

TEST(LiveNode, PoseInAnotherFrameIsTransformedToTheTrackFrame)
{
  ContactClient client;
  tf2_ros::StaticTransformBroadcaster broadcaster;
  const ros::Time stamp = ContactClient::nextStamp();
  broadcaster.sendTransform(shifted("vehicle", 0.001, stamp));
  auto pose = ContactClient::pose(0.002, stamp);
  pose.header.frame_id = "vehicle";
  std::optional<WheelsetContact> result;
  for (int i = 0; i < 20 && !(result && result->status == WheelsetContact::OK); ++i)
  {
    pose.header.stamp = ContactClient::nextStamp();
    result = client.request(pose, ContactClient::load(-200e3, pose.header.stamp));
  }
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, WheelsetContact::OK) << result->status_text;
  EXPECT_NEAR(result->wheelset.position.y, 0.003, 1e-12);
}

TEST(LiveNode, NodeWaitsForALateTransform)
{
  ContactClient client;
  tf2_ros::TransformBroadcaster broadcaster;
  spinUntil([] { return false; }, 0.5);  // time for the node to subscribe to the broadcaster
  const ros::Time early = ContactClient::nextStamp();
  broadcaster.sendTransform(shifted("bogie", 0.001, early));

  const ros::Time late = ContactClient::nextStamp();
  auto pose = ContactClient::pose(0, late);
  pose.header.frame_id = "bogie";
  const std::size_t before = client.results().size();
  client.send(pose);
  client.send(ContactClient::load(-200e3, late));
  spinUntil([] { return false; }, 0.02);
  broadcaster.sendTransform(shifted("bogie", 0.002, late));
  ASSERT_TRUE(client.waitForResults(before + 1));
  EXPECT_EQ(client.results().back().status, WheelsetContact::OK) << client.results().back().status_text;
  EXPECT_NEAR(client.results().back().wheelset.position.y, 0.002, 1e-12);
}

// Each pose waits up to 0.1 s from its arrival, so that poses that arrive together wait together. If the waits followed
// one another, 1500 poses would need 150 s, and the client would give up.
TEST(LiveNode, PosesWithoutATransformWaitTogether)
{
  ContactClient client;
  constexpr std::size_t batch = 150;  // below ContactServer::input_capacity: no input is dropped
  constexpr std::size_t total = 10 * batch;
  std::size_t sent = 0;
  const auto send_batch = [&]
  {
    for (std::size_t i = 0; i < batch; ++i)
    {
      auto pose = ContactClient::pose(0, ContactClient::nextStamp());
      pose.header.frame_id = "nowhere";
      client.send(pose);
      client.send(ContactClient::load(-200e3, pose.header.stamp));
    }
    sent += batch;
  };
  EXPECT_TRUE(spinUntil(
      [&]
      {
        if (client.results().size() == sent && sent < total)
        {
          send_batch();
        }
        return client.results().size() == total;
      }))
      << client.results().size() << " results";
  for (const WheelsetContact& result : client.results())
  {
    EXPECT_EQ(result.status, WheelsetContact::NO_TRANSFORM);
  }
}

TEST(LiveNode, BagLoopIsEvaluatedAgain)
{
  ContactClient client;
  const ros::Time begin = ContactClient::nextStamp();
  for (int loop = 0; loop < 3; ++loop)
  {
    for (int i = 0; i < 10; ++i)
    {
      const ros::Time stamp = begin + ros::Duration(0.001 * i);
      ASSERT_TRUE(client.request(ContactClient::pose(0, stamp), ContactClient::load(-200e3, stamp)));
      EXPECT_EQ(client.results().back().header.stamp, stamp);
    }
  }
  EXPECT_EQ(client.results().size(), 30U);
}

TEST(LiveNode, EachEvaluationOfALockstepLoopWithARepeatedStampHasAResult)
{
  ContactClient client;
  for (int step = 0; step < 5; ++step)
  {
    const ros::Time stamp = ContactClient::nextStamp();
    for (const double y : {1e-3, 2e-3, 1e-3})  // as by a method with a predictor and two correctors
    {
      const auto result = client.request(ContactClient::pose(y, stamp), ContactClient::load(-200e3, stamp));
      ASSERT_TRUE(result);
      EXPECT_EQ(result->header.stamp, stamp);
      EXPECT_DOUBLE_EQ(result->wheelset.position.y, y);
      EXPECT_EQ(result->status, WheelsetContact::OK) << result->status_text;
    }
  }
}

TEST(LiveNode, EveryMessageIsEvaluatedOrCountedAsDropped)
{
  ContactClient client;
  const Report before = nextReport("/contact_node");
  const std::size_t results = client.results().size();
  const ros::Time first = ContactClient::nextStamp(), second = ContactClient::nextStamp();
  client.send(ContactClient::pose(0, first));  // without a load
  client.send(ContactClient::pose(0, second));
  client.send(ContactClient::pose(0, second));  // without a second load
  client.send(ContactClient::load(-200e3, second));
  client.send(ContactClient::load(-200e3, first - ros::Duration(5)));  // time goes back, without a pose
  ASSERT_TRUE(client.waitForResults(results + 1));
  Report after;
  for (int i = 0; i < 5 && number(after, "messages received") != number(before, "messages received") + 5; ++i)
  {
    after = nextReport("/contact_node");
  }
  const auto change = [&](const std::string& key) { return number(after, key) - number(before, key); };
  EXPECT_EQ(change("messages received"), 5U);
  EXPECT_EQ(change("results"), 1U);
  EXPECT_EQ(change("messages dropped: no message with a matching stamp"), 1U);
  EXPECT_EQ(number(after, "messages waiting for a match"), 2U) << "the second pose and the load after the jump";
  EXPECT_TRUE(client.request(0.0)) << "no result for a valid pair";
}

TEST(LiveNode, GivenHeightNeedsNoLoad)
{
  ros::NodeHandle nh;
  const auto publisher = nh.advertise<geometry_msgs::PoseStamped>("/given/wheelset/pose", 10);
  std::vector<WheelsetContact> results;
  const auto subscriber = nh.subscribe<WheelsetContact>(
      "/given/contact_node/contact", 10, [&](const WheelsetContact::ConstPtr& m) { results.push_back(*m); });
  EXPECT_TRUE(spinUntil([&] { return subscriber.getNumPublishers() > 0; }));
  EXPECT_TRUE(spinUntil(
      [&]
      {
        auto pose = ContactClient::pose(0, ContactClient::nextStamp());
        pose.pose.position.z = 0.4597427;
        publisher.publish(pose);
        spinUntil([&] { return !results.empty(); }, 0.2);
        return !results.empty();
      }));
  EXPECT_EQ(results[0].status, WheelsetContact::OK) << results[0].status_text;
  // A change of 1e-6 m in the approach of 75e-6 m changes the force by about 2 %. The height above has an error of at
  // most 1e-7 m.
  EXPECT_NEAR(results[0].left_rail.vertical_force, 100e3, 3e3);
  EXPECT_GT(nextReport("/given/contact_node", "wheelset/pose topic status").level, 0) << "max_delay of stamps of 1970";
}
