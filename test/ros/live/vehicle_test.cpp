// SPDX-License-Identifier: BSD-3-Clause
// Several wheelsets in one node, compared with a node for each.
#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include <wheel_rail_contact/EvaluateWheelset.h>
#include <wheel_rail_contact/EvaluateWheelsets.h>
#include "../message_bytes.h"
#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
std::string node(const std::string& wheelset)
{
  return wheelset + "/contact_node";
}

/// A wheelset of the node with all of them, and the same in its own node.
struct BothClients
{
  explicit BothClients(const std::string& name)
      : one("/one/" + name, node("/one/" + name)), apart("/apart/" + name, node("/apart/" + name))
  {
  }

  ContactClient one, apart;
};

WheelsetInput input(const std::string& wheelset, double y, const ros::Time& stamp)
{
  WheelsetInput state;
  state.wheelset = wheelset;
  state.pose = ContactClient::pose(y, stamp);
  state.load = ContactClient::load(-200e3, stamp);
  return state;
}
}  // namespace

TEST(LiveVehicle, EachWheelsetHasTheBytesOfANodeOfItsOwn)
{
  BothClients rear("rear");
  constexpr std::size_t pairs = 20;
  for (std::size_t i = 0; i < pairs; ++i)
  {
    const ros::Time stamp = ContactClient::nextStamp();
    for (ContactClient* client : {&rear.one, &rear.apart})
    {
      client->send(ContactClient::pose(-2e-4 * static_cast<double>(i), stamp));
      client->send(ContactClient::load(-200e3, stamp));
    }
  }
  ASSERT_TRUE(rear.one.waitForResults(pairs) && rear.apart.waitForResults(pairs));
  for (std::size_t i = 0; i < pairs; ++i)
  {
    EXPECT_EQ(bytesWithoutTime(rear.one.results()[i]), bytesWithoutTime(rear.apart.results()[i])) << i;
    ASSERT_FALSE(rear.one.results()[i].patches.empty()) << rear.one.results()[i].status_text;
    EXPECT_EQ(rear.one.results()[i].patches[0].method, "hertz") << "its own parameter";
  }
}

TEST(LiveVehicle, NeighboursByPlaceHaveTheBytesOfNeighboursByTopic)
{
  BothClients front("front"), behind("behind");
  const ros::Time early = ContactClient::nextStamp(), late = ContactClient::nextStamp();
  for (ContactClient* client : {&front.one, &front.apart})
  {
    const auto result = client->request(ContactClient::pose(6.5e-3, early), ContactClient::load(-200e3, early));
    ASSERT_TRUE(result && result->status == WheelsetContact::OK);
  }
  std::optional<WheelsetContact> one, apart;
  // The result of the front wheelset may reach the other one later than this program.
  ASSERT_TRUE(spinUntil(
      [&]
      {
        one = behind.one.request(ContactClient::pose(1e-3, late), ContactClient::load(-200e3, late));
        apart = behind.apart.request(ContactClient::pose(1e-3, late), ContactClient::load(-200e3, late));
        return !one || !apart || (one->status_text.empty() && apart->status_text.empty());
      }));
  ASSERT_TRUE(one && apart);
  EXPECT_EQ(bytesWithoutTime(*one), bytesWithoutTime(*apart));
}

TEST(LiveVehicle, OneCallForAllHasTheResultOfASingleCallForEachInput)
{
  const ros::Time stamp(500);
  EvaluateWheelsets all;
  for (const char* wheelset : {"rear", "behind", "front", "rear"})
  {
    all.request.inputs.push_back(input(wheelset, 1e-3 * static_cast<double>(all.request.inputs.size()), stamp));
  }
  all.request.inputs.push_back(input("front", 0.09, stamp));  // beside the rail
  all.request.inputs.push_back(input("middle", 0, stamp));
  ASSERT_TRUE(ros::service::waitForService("/one/contact_node/evaluate_all", ros::Duration(60)));
  ASSERT_TRUE(ros::service::call("/one/contact_node/evaluate_all", all));
  ASSERT_EQ(all.response.contacts.size(), all.request.inputs.size());
  for (std::size_t i = 0; i < 5; ++i)
  {
    EvaluateWheelset single;
    single.request.pose = all.request.inputs[i].pose;
    single.request.load = all.request.inputs[i].load;
    ASSERT_TRUE(ros::service::call(node("/apart/" + all.request.inputs[i].wheelset) + "/evaluate", single)) << i;
    EXPECT_EQ(bytesWithoutTime(all.response.contacts[i]), bytesWithoutTime(single.response.contact)) << i;
    EXPECT_EQ(single.response.contact.status == WheelsetContact::OK, i < 4) << i;
  }
  const WheelsetContact& unknown = all.response.contacts[5];
  EXPECT_EQ(unknown.status, WheelsetContact::INVALID_INPUT);
  EXPECT_EQ(unknown.status_text, "no wheelset 'middle'; the names in wheelsets are behind, front, rear");
  EXPECT_EQ(unknown.header.stamp, stamp);
}

TEST(LiveVehicle, OnlyTheWheelsetThatIsToldToBroadcastsFramesAndWrenches)
{
  BothClients rear("rear");
  ros::NodeHandle nh;
  std::vector<std::string> frames;
  const auto subscriber = nh.subscribe<tf2_msgs::TFMessage>("/tf", 10,
                                                            [&](const tf2_msgs::TFMessage::ConstPtr& message)
                                                            {
                                                              for (const auto& frame : message->transforms)
                                                              {
                                                                frames.push_back(frame.child_frame_id);
                                                              }
                                                            });
  std::optional<geometry_msgs::WrenchStamped> wrench;
  const auto wrenches = nh.subscribe<geometry_msgs::WrenchStamped>("/one/rear/contact_node/left_wheel/wrench", 10,
                                                                   [&](const auto& message) { wrench = *message; });
  std::optional<WheelsetContact> result;
  ASSERT_TRUE(spinUntil(
      [&]
      {
        result = rear.one.request(1e-3);
        return result &&
               spinUntil([&] { return wrench && wrench->header.stamp == result->header.stamp && !frames.empty(); },
                         0.2);
      }));
  EXPECT_EQ(wrench->header.frame_id, "one/rear/left_contact");
  EXPECT_NEAR(wrench->wrench.force.z, result->left_wheel.vertical_force, 1e-6);
  EXPECT_EQ(std::set<std::string>(frames.begin(), frames.end()),
            (std::set<std::string>{"one/rear", "one/rear/left_contact", "one/rear/right_contact"}));
  ros::master::V_TopicInfo topics;
  ASSERT_TRUE(ros::master::getTopics(topics));
  for (const auto& topic : topics)
  {
    EXPECT_TRUE(topic.name.find("/wrench") == std::string::npos || topic.name.rfind("/one/rear/", 0) == 0)
        << topic.name;
  }
}
