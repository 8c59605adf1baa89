// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <ros/serialization.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "wheel_rail_contact/replay/replay.h"

using namespace wheel_rail_contact;

namespace
{
constexpr int pairs = 1000;  ///< whose answers fill more than a chunk

template <typename Message>
std::string bytesOfMessage(const Message& message)
{
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return {bytes.begin(), bytes.end()};
}

template <typename Message>
std::uint32_t addTopic(const std::string& topic, BagWriter& bag)
{
  BagConnection connection;
  connection.topic = topic;
  connection.header.set("topic", topic)
      .set("type", ros::message_traits::datatype<Message>())
      .set("md5sum", ros::message_traits::md5sum<Message>())
      .set("message_definition", ros::message_traits::definition<Message>());
  return bag.addConnection(connection);
}

/// A wheelset that moves sideways, 1000 pairs per second.
void writePairs(const std::string& path)
{
  BagWriter bag(path, "none");
  const auto pose_topic = addTopic<geometry_msgs::PoseStamped>("/wheelset/pose", bag);
  const auto load_topic = addTopic<geometry_msgs::WrenchStamped>("/wheelset/load", bag);
  geometry_msgs::PoseStamped pose;
  geometry_msgs::WrenchStamped load;
  pose.header.frame_id = "track";
  pose.pose.orientation.w = 1;
  load.wrench.force.z = -200e3;  // [N]
  for (int i = 0; i < pairs; ++i)
  {
    const ros::Time stamp = ros::Time(1) + ros::Duration(1e-3 * i);
    pose.header.stamp = load.header.stamp = stamp;
    pose.pose.position.y = 4e-6 * i;  // [m]
    bag.write(pose_topic, stamp.toNSec(), bytesOfMessage(pose));
    bag.write(load_topic, stamp.toNSec(), bytesOfMessage(load));
  }
  bag.close();
}

std::string contentOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class ReplayInterrupted : public testing::Test
{
 protected:
  void SetUp() override
  {
    std::string name = (std::filesystem::temp_directory_path() / "replay_interrupted.XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    writePairs(folder_ + "/in.bag");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// @return answers in the output after the run
  std::uint64_t run(bool resume, bool interrupted) const
  {
    ReplayOptions options;
    options.input = folder_ + "/in.bag";
    options.output = folder_ + "/out.bag";
    options.csv = folder_ + "/out.csv";
    options.threads = 2;
    options.resume = resume;
    Replay replay(options);
    replay.run(std::atomic<bool>(interrupted));
    return replay.answers();
  }

  std::string folder_;
};
}  // namespace

// Ctrl-C that comes before a resumed run has passed over what is there leaves all of that there.
TEST_F(ReplayInterrupted, ResumedRunInterruptedAtOnceLosesNothing)
{
  EXPECT_EQ(run(false, false), pairs);
  const std::string bag = contentOf(folder_ + "/out.bag"), table = contentOf(folder_ + "/out.csv");
  ASSERT_GT(bag.size(), BagWriter::full_chunk);

  const std::uint64_t kept = run(true, true);
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, pairs);
  const BagFile file(folder_ + "/out.bag");
  const BagContents contents = readContents(file, [](const std::string&) { return true; });
  EXPECT_EQ(contents.fault, "");
  ASSERT_EQ(contents.connections.size(), 1U);
  EXPECT_EQ(contents.messages, (std::map<std::uint32_t, std::uint64_t>{{0, kept}}));

  EXPECT_EQ(run(true, false), pairs);
  EXPECT_TRUE(contentOf(folder_ + "/out.bag") == bag);
  EXPECT_TRUE(contentOf(folder_ + "/out.csv") == table);
}
