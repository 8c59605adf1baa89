// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/input_pairing.h"

#include <boost/make_shared.hpp>
#include <set>

#include "message_bytes.h"

using namespace wheel_rail_contact;

namespace
{
/// Writes a value into a message.
struct Writer
{
  double value;
  void to(geometry_msgs::PoseStamped& message) const { message.pose.position.y = value; }
  void to(geometry_msgs::WrenchStamped& message) const { message.wrench.force.y = value; }
  void to(RailDisplacements& message) const { message.left.lateral = value; }
  void to(geometry_msgs::PointStamped& message) const { message.point.x = value; }
  void to(geometry_msgs::TwistStamped& message) const { message.twist.linear.x = value; }
};

/// Message of a topic with a stamp [s] and a value, which a complete input shows.
InputMessage message(InputTopic topic, double stamp, double value = 0, const std::string& frame = "")
{
  return withMessageType(topic,
                         [&](auto type)
                         {
                           const auto made = boost::make_shared<typename decltype(type)::Message>();
                           made->header.stamp = ros::Time(stamp);
                           made->header.frame_id = frame;
                           Writer{value}.to(*made);
                           return InputMessage(made);
                         });
}

NodeConfig allInputs()
{
  NodeConfig config;
  config.model.rail_bending.model = core::RailBendingConfig::Model::compliance;
  config.model.rail_bending.lateral_force = core::RailBendingConfig::LateralForce::topic;
  config.displacement_topic = config.distance_topic = true;
  config.model.creep.method = core::CreepMethod::linear;
  return config;
}

std::set<std::string> namesOf(const NodeConfig& config)
{
  std::set<std::string> names;
  for (const InputTopic topic : inputTopics(config))
  {
    names.insert(nameOf(topic));
  }
  return names;
}
}  // namespace

TEST(InputPairing, ConfigurationDeterminesTheInputTopics)
{
  NodeConfig config;
  EXPECT_EQ(namesOf(config), (std::set<std::string>{"wheelset/pose", "wheelset/load"}));
  config.model.wheelset.solve_height_and_roll = false;
  EXPECT_EQ(namesOf(config), std::set<std::string>{"wheelset/pose"});
  config.model.rail_bending.lateral_force = core::RailBendingConfig::LateralForce::topic;
  EXPECT_EQ(namesOf(config), std::set<std::string>{"wheelset/pose"}) << "rigid rails need no force";
  config.displacement_topic = true;
  EXPECT_EQ(namesOf(config), (std::set<std::string>{"wheelset/pose", "wheelset/rail_displacement"}));
  config.displacement_topic = false;
  config.distance_topic = true;
  EXPECT_EQ(namesOf(config), (std::set<std::string>{"wheelset/pose", "wheelset/distance"}));
  config.distance_topic = false;
  config.model.creep.method = core::CreepMethod::exact;
  EXPECT_EQ(namesOf(config), (std::set<std::string>{"wheelset/pose", "wheelset/twist"}));
  EXPECT_EQ(namesOf(allInputs()), (std::set<std::string>{"wheelset/pose", "wheelset/load", "wheelset/left_rail_force",
                                                         "wheelset/right_rail_force", "wheelset/rail_displacement",
                                                         "wheelset/distance", "wheelset/twist"}));
}

TEST(InputPairing, InputHasTheMessageOfEachTopic)
{
  InputPairing pairing(allInputs());
  double value = 0;
  std::vector<ContactInput> inputs;
  for (const InputTopic topic : {InputTopic::distance, InputTopic::right_rail_force, InputTopic::load, InputTopic::pose,
                                 InputTopic::rail_displacement, InputTopic::left_rail_force, InputTopic::twist})
  {
    EXPECT_TRUE(inputs.empty()) << "complete before " << nameOf(topic);
    inputs = pairing.add(topic, message(topic, 10, ++value));
  }
  ASSERT_EQ(inputs.size(), 1U);
  const ContactInput& input = inputs.front();
  EXPECT_EQ(input.distance->point.x, 1);
  EXPECT_EQ(input.rail_force.right->wrench.force.y, 2);
  EXPECT_EQ(input.load->wrench.force.y, 3);
  EXPECT_EQ(input.pose->pose.position.y, 4);
  EXPECT_EQ(input.rail_displacement->left.lateral, 5);
  EXPECT_EQ(input.rail_force.left->wrench.force.y, 6);
  EXPECT_EQ(input.twist->twist.linear.x, 7);
  EXPECT_EQ(pairing.counts().paired, 7U);
}

TEST(InputPairing, MessagesOfOtherTopicsAreIgnored)
{
  InputPairing pairing{NodeConfig()};
  for (const InputTopic topic : {InputTopic::left_rail_force, InputTopic::rail_displacement, InputTopic::distance})
  {
    EXPECT_TRUE(pairing.add(topic, message(topic, 10)).empty());
  }
  EXPECT_EQ(pairing.counts().received, 0U);
  EXPECT_TRUE(pairing.add(InputTopic::pose, message(InputTopic::pose, 10)).empty());
  const auto inputs = pairing.add(InputTopic::load, message(InputTopic::load, 10));
  ASSERT_EQ(inputs.size(), 1U);
  const ContactInput& input = inputs.front();
  EXPECT_FALSE(input.rail_force.left || input.rail_displacement || input.distance);
}

TEST(InputPairing, DisplacementAndDistanceArePairedWithinTheSlop)
{
  NodeConfig config = allInputs();
  config.model.rail_bending.lateral_force = core::RailBendingConfig::LateralForce::contact;
  config.model.creep.method = core::CreepMethod::none;
  config.slop = 0.004;
  InputPairing pairing(config);
  for (const double stamp : {10.0, 10.01, 10.02})
  {
    EXPECT_TRUE(pairing.add(InputTopic::pose, message(InputTopic::pose, stamp)).empty());
    EXPECT_TRUE(pairing.add(InputTopic::load, message(InputTopic::load, stamp)).empty());
    EXPECT_TRUE(pairing.add(InputTopic::distance, message(InputTopic::distance, stamp + 0.003, stamp)).empty());
  }
  EXPECT_TRUE(pairing.add(InputTopic::rail_displacement, message(InputTopic::rail_displacement, 10.005)).empty())
      << "too far from both poses";
  const auto inputs = pairing.add(InputTopic::rail_displacement, message(InputTopic::rail_displacement, 10.021));
  ASSERT_EQ(inputs.size(), 1U);
  const ContactInput& input = inputs.front();
  EXPECT_EQ(input.pose->header.stamp, ros::Time(10.02));
  EXPECT_EQ(input.distance->point.x, 10.02);
  // The messages of the first two poses, and the first displacement.
  EXPECT_EQ(pairing.counts()[DropReason::unmatched], 7U);
  EXPECT_TRUE(pairing.isSettled());
}

TEST(InputPairing, MessagesWithoutAStampAreNeverPaired)
{
  InputPairing pairing{NodeConfig()};
  std::vector<ContactInput> inputs;
  for (const double stamp : {0.0, 5.0, 0.0, 6.0, 0.0})
  {
    EXPECT_TRUE(pairing.add(InputTopic::pose, message(InputTopic::pose, stamp)).empty());
    const auto completed = pairing.add(InputTopic::load, message(InputTopic::load, stamp));
    inputs.insert(inputs.end(), completed.begin(), completed.end());
  }
  ASSERT_EQ(inputs.size(), 2U) << "a stamp of 0 is no sign of time that went back";
  EXPECT_EQ(inputs[0].pose->header.stamp, ros::Time(5));
  EXPECT_EQ(inputs[1].load->header.stamp, ros::Time(6));
  EXPECT_EQ(pairing.counts()[DropReason::unstamped], 6U);
  EXPECT_EQ(pairing.droppedPoses(), 3U);
  EXPECT_TRUE(pairing.isSettled());
}

TEST(InputPairing, LongFrameNamesOfWaitingMessagesAreCut)
{
  const std::string frame(1 << 20, 'x');
  InputPairing pairing(allInputs());
  std::vector<ContactInput> inputs;
  for (const InputTopic topic : inputTopics(allInputs()))
  {
    inputs = pairing.add(topic, message(topic, 10, 0.3, frame));
  }
  ASSERT_EQ(inputs.size(), 1U);
  const ContactInput& input = inputs.front();
  const std::string::size_type longest = InputPairing::longest_frame_name;
  for (const std_msgs::Header* header :
       {&input.pose->header, &input.load->header, &input.rail_force.left->header, &input.rail_force.right->header,
        &input.rail_displacement->header, &input.distance->header, &input.twist->header})
  {
    EXPECT_GT(header->frame_id.size(), longest) << "the cut name must not become a valid name";
    EXPECT_LE(header->frame_id.capacity(), 2 * longest);
  }
  const auto whole = std::get<geometry_msgs::PoseStampedConstPtr>(message(InputTopic::pose, 10, 0.3));
  EXPECT_EQ(bytesOf(input.pose->pose), bytesOf(whole->pose));
}
