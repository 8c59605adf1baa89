// SPDX-License-Identifier: BSD-3-Clause
#include <visualization_msgs/MarkerArray.h>

#include "../../usual_headers.h"
#include "../message_bytes.h"
#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Result for a pair that `change` has modified. Then a valid pair is sent, to check that the node still works.
template <typename Change>
WheelsetContact requestChanged(ContactClient& client, const Change& change)
{
  const ros::Time stamp = ContactClient::nextStamp();
  auto pose = ContactClient::pose(0, stamp);
  auto load = ContactClient::load(-200e3, stamp);
  change(pose, load);
  const auto result = client.request(pose, load);
  const auto valid = client.request(0.001);
  EXPECT_TRUE(valid && valid->status == WheelsetContact::OK) << "no result for valid input";
  return result.value_or(WheelsetContact());
}

using Pose = geometry_msgs::PoseStamped;
using Load = geometry_msgs::WrenchStamped;

void expectRefused(const WheelsetContact& result, int status, const std::string& reason)
{
  EXPECT_EQ(result.status, status);
  EXPECT_NE(result.status_text.find(reason), std::string::npos) << result.status_text;
  EXPECT_TRUE(result.patches.empty());
}
}  // namespace

// Reference values of the program CONTACT for the Manchester contact benchmark, 100 kN per wheel, y = 0, inclination
// 1:40: 982.1 MPa, 192.0 mm², axle at z = 459.743 mm. The bounds of 1.5 % and 2 % are the required agreement of the
// complete calculation at tolerance 0.003.
TEST(LiveNode, MatchesTheManchesterBenchmarkAndKeepsTheStamp)
{
  ContactClient client;
  const ros::Time stamp = ContactClient::nextStamp();
  const auto result = client.request(ContactClient::pose(0, stamp), ContactClient::load(-200e3, stamp));
  ASSERT_TRUE(result);
  EXPECT_EQ(result->header.stamp, stamp);
  EXPECT_EQ(result->header.frame_id, "track");
  EXPECT_EQ(result->status, WheelsetContact::OK);
  EXPECT_EQ(result->status_text, "");
  EXPECT_NEAR(result->wheelset.position.z, 0.459743, 3e-6);
  EXPECT_NEAR(result->left_rail.vertical_force, 100e3, 100);
  ASSERT_EQ(result->patches.size(), 2U);
  for (const ContactPatch& patch : result->patches)
  {
    EXPECT_NEAR(patch.max_pressure, 982.1e6, 0.015 * 982.1e6);
    EXPECT_NEAR(patch.area, 192.0e-6, 0.02 * 192.0e-6);
    ASSERT_EQ(patch.grid.pressure.size(), std::size_t{patch.grid.nx} * patch.grid.ny);
    double force = 0;
    for (const float p : patch.grid.pressure)
    {
      force += p * patch.grid.dx * patch.grid.dy;
    }
    // The normal force is the resultant of the pressure, whose normals differ by 0.02 rad.
    EXPECT_NEAR(force, patch.normal_force, 1e-3 * patch.normal_force);
  }
  EXPECT_EQ(result->patches[0].side, ContactPatch::LEFT);
  EXPECT_EQ(result->patches[1].side, ContactPatch::RIGHT);
  EXPECT_GT(result->solve_time, 0);
}

TEST(LiveNode, PublishesOneResultForEachPairInOrder)
{
  ContactClient client;
  constexpr int count = 100;
  std::vector<ros::Time> stamps;
  for (int i = 0; i < count; ++i)
  {
    stamps.push_back(ContactClient::nextStamp());
    client.send(ContactClient::pose(-5e-5 * i, stamps.back()));
    client.send(ContactClient::load(-200e3, stamps.back()));
  }
  ASSERT_TRUE(client.waitForResults(count));
  for (int i = 0; i < count; ++i)
  {
    const auto& result = client.results()[static_cast<std::size_t>(i)];
    EXPECT_EQ(result.header.stamp, stamps[static_cast<std::size_t>(i)]);
    EXPECT_EQ(result.status, WheelsetContact::OK) << result.status_text;
    EXPECT_DOUBLE_EQ(result.wheelset.position.y, -5e-5 * i);
  }
}

TEST(LiveNode, RefusesNonFiniteNumbersAndInvalidQuaternions)
{
  ContactClient client;
  const int invalid = WheelsetContact::INVALID_INPUT;
  expectRefused(requestChanged(client, [](Pose& pose, Load&) { pose.pose.position.y = not_a_number; }), invalid,
                "position");
  expectRefused(requestChanged(client, [](Pose& pose, Load&) { pose.pose.position.z = infinity; }), invalid,
                "position");
  expectRefused(requestChanged(client, [](Pose& pose, Load&) { pose.pose.orientation.x = not_a_number; }), invalid,
                "quaternion");
  expectRefused(requestChanged(client, [](Pose& pose, Load&) { pose.pose.orientation.w = 0; }), invalid, "quaternion");
  expectRefused(requestChanged(client, [](Pose& pose, Load&) { pose.pose.orientation.w = 5e-324; }), invalid,
                "quaternion");
  expectRefused(requestChanged(client, [](Pose&, Load& load) { load.wrench.force.z = not_a_number; }), invalid,
                "force");
  expectRefused(requestChanged(client, [](Pose&, Load& load) { load.wrench.torque.x = -infinity; }), invalid, "torque");
}

TEST(LiveNode, ResultOfARejectedInputHasNoPose)
{
  ContactClient client;
  requestChanged(client, [](Pose& pose, Load&) { pose.pose.position.x = 52; });
  const auto result = requestChanged(client, [](Pose& pose, Load&) { pose.pose.position.x = not_a_number; });
  EXPECT_EQ(bytesOf(result.wheelset), bytesOf(geometry_msgs::Pose()));
  EXPECT_EQ(bytesOf(result.left_rail), bytesOf(RailDeflection()));
  EXPECT_EQ(bytesOf(result.right_rail), bytesOf(RailDeflection()));
}

TEST(LiveNode, RefusesHugeValuesAndStatesOffTheTrack)
{
  ContactClient client;
  const int invalid = WheelsetContact::INVALID_INPUT;
  expectRefused(requestChanged(client, [](Pose& pose, Load&) { pose.pose.position.y = 1e300; }), invalid, "lateral");
  expectRefused(requestChanged(client, [](Pose&, Load& load) { load.wrench.force.z = -1e300; }), invalid, "load");
  const auto turned_round = [](Pose& pose, Load&)
  {
    pose.pose.orientation.w = 0;
    pose.pose.orientation.z = 1;
  };
  expectRefused(requestChanged(client, turned_round), invalid, "yaw");
  const auto beside = requestChanged(client, [](Pose& pose, Load&) { pose.pose.position.y = 0.09; });
  EXPECT_TRUE(beside.status != WheelsetContact::OK && beside.patches.empty()) << "9 cm off the centre of the track";
  EXPECT_NE(beside.status_text, "");
  EXPECT_EQ(beside.wheelset.position.y, 0.09) << "the pose is that of the input";
}

TEST(LiveNode, RefusesFramesWithoutATransformToTheTrack)
{
  ContactClient client;
  const int no_transform = WheelsetContact::NO_TRANSFORM;
  expectRefused(requestChanged(client, [](Pose& pose, Load&) { pose.header.frame_id = "nowhere"; }), no_transform,
                "nowhere");
  expectRefused(requestChanged(client, [](Pose& pose, Load&) { pose.header.frame_id = ""; }), no_transform, "frame_id");
  expectRefused(requestChanged(client, [](Pose&, Load& load) { load.header.frame_id = "wheelset"; }),
                WheelsetContact::INVALID_INPUT, "wheelset");
}

TEST(LiveNode, LiftOffIsAResultWithPatchesOfTheOtherWheel)
{
  ContactClient client;
  const auto result = requestChanged(client, [](Pose&, Load& load) { load.wrench.torque.x = 160e3; });
  EXPECT_EQ(result.status, WheelsetContact::LIFT_OFF);
  EXPECT_NE(result.status_text, "");
  for (const ContactPatch& patch : result.patches)
  {
    EXPECT_EQ(patch.side, ContactPatch::RIGHT);
  }
}

TEST(LiveNode, PublishesMarkersForSubscribers)
{
  ContactClient client;
  ros::NodeHandle nh;
  visualization_msgs::MarkerArray shown, latched;
  const auto markers = nh.subscribe<visualization_msgs::MarkerArray>(
      "/contact_node/markers", 10, [&](const visualization_msgs::MarkerArray::ConstPtr& m) { shown = *m; });
  const auto profiles = nh.subscribe<visualization_msgs::MarkerArray>(
      "/contact_node/profiles", 10, [&](const visualization_msgs::MarkerArray::ConstPtr& m) { latched = *m; });
  EXPECT_TRUE(spinUntil([&] { return !latched.markers.empty(); })) << "profiles are latched";
  EXPECT_TRUE(spinUntil(
      [&]
      {
        client.request(0.002);
        return !shown.markers.empty();
      }));
  for (const auto& marker : shown.markers)
  {
    EXPECT_EQ(marker.header.frame_id, "track");
  }
}

TEST(LiveNode, LastResultBeforeAPauseIsDrawn)
{
  ContactClient client;
  ros::NodeHandle nh;
  ros::Time shown;
  const auto markers = nh.subscribe<visualization_msgs::MarkerArray>(
      "/contact_node/markers", 10,
      [&](const visualization_msgs::MarkerArray::ConstPtr& m) { shown = m->markers.at(0).header.stamp; });
  EXPECT_TRUE(spinUntil(
      [&]
      {
        client.request(0.002);
        return !shown.isZero();
      }));
  ros::Time last;
  for (int i = 0; i < 5; ++i)
  {
    last = ContactClient::nextStamp();
    client.send(ContactClient::pose(1e-4 * i, last));
    client.send(ContactClient::load(-200e3, last));
  }
  EXPECT_TRUE(spinUntil([&] { return shown == last; }));
}

TEST(LiveNode, BuildsNoOutputWithoutSubscribers)
{
  ContactClient client("/unsubscribed", "");
  for (int i = 0; i < 10; ++i)
  {
    const ros::Time stamp = ContactClient::nextStamp();
    client.send(ContactClient::pose(0, stamp));
    client.send(ContactClient::load(-200e3, stamp));
  }
  Report report;
  for (int i = 0; i < 5 && report.values["results"] != "10"; ++i)
  {
    report = nextReport("/unsubscribed/contact_node");
  }
  EXPECT_EQ(report.values["results"], "10");
  EXPECT_EQ(report.values["contact messages built"], "0");
  EXPECT_EQ(report.values["marker arrays built"], "0");
  const Report poses = nextReport("/unsubscribed/contact_node", "wheelset/pose topic status");
  EXPECT_EQ(poses.level, 0) << poses.message;
  EXPECT_EQ(poses.values.at("Events since startup"), "10");
}
