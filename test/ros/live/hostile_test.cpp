// SPDX-License-Identifier: BSD-3-Clause
// contact_node with invalid and excessive input. At the end of each test, each pair has a result or is counted as
// dropped.
#include "../../usual_headers.h"
#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
using Pose = geometry_msgs::PoseStamped;
using Load = geometry_msgs::WrenchStamped;

const std::string node = "/hostile/contact_node";

std::uint64_t sumOf(const Report& report, const std::string& beginning)
{
  std::uint64_t sum = 0;
  for (const auto& [key, value] : report.values)
  {
    sum += key.rfind(beginning, 0) == 0 ? std::stoull(value) : 0;
  }
  return sum;
}

/// A client that compares the counts of the node with the messages that it has sent.
class HostileInput : public testing::Test
{
 protected:
  void SetUp() override
  {
    // The first reports may still be about the previous test. Then the node reports OK without input.
    for (int i = 0; i < 3 && before_.message != "no input"; ++i)
    {
      before_ = nextReport(node);
    }
    EXPECT_EQ(before_.message, "no input");
    EXPECT_EQ(before_.level, diagnostic_msgs::DiagnosticStatus::OK);
  }

  void sendPair(double y, const ros::Time& stamp)
  {
    client_.send(ContactClient::pose(y, stamp));
    client_.send(ContactClient::load(-200e3, stamp));
    sent_ += 2;
  }

  std::uint64_t change(const std::string& key) const { return number(after_, key) - number(before_, key); }

  /// Waits until the node has processed all sent messages, and checks that each is evaluated, dropped or waiting.
  void expectAllCounted()
  {
    for (int i = 0; i < 20 && !allCounted(); ++i)
    {
      after_ = nextReport(node);
    }
    EXPECT_EQ(change("messages received"), sent_);
    EXPECT_EQ(change("internal errors"), 0U);
    EXPECT_TRUE(allCounted()) << change("results") << " results, " << change("inputs dropped: overload")
                              << " inputs dropped, " << droppedMessages() << " messages dropped, " << waiting()
                              << " waiting, of " << sent_;
    spinUntil([&] { return client_.results().size() >= change("results"); });
    EXPECT_EQ(client_.results().size(), change("results"));
  }

  std::uint64_t droppedMessages() const
  {
    return sumOf(after_, "messages dropped: ") - sumOf(before_, "messages dropped: ");
  }
  std::uint64_t waiting() const
  {
    return number(after_, "messages waiting for a match") - number(before_, "messages waiting for a match");
  }
  bool allCounted() const
  {
    return 2 * (change("results") + change("inputs dropped: overload")) + droppedMessages() + waiting() == sent_;
  }

  ContactClient client_{"/hostile", node};
  Report before_, after_;
  std::uint64_t sent_ = 0;  ///< number of messages
};

/// Memory of the node's process: an entry of /proc/PID/status [MB]; NaN if there is none.
double memory(const std::string& entry)
{
  std::ifstream status("/proc/" + std::to_string(processOf(node)) + "/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind(entry + ":", 0) == 0)
    {
      return 1.024e-3 * std::stod(line.substr(entry.size() + 1));
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Resets VmHWM, the peak memory of the node, to its current memory.
void resetPeakMemory()
{
  std::ofstream("/proc/" + std::to_string(processOf(node)) + "/clear_refs") << 5;
}

bool isFinite(const geometry_msgs::Pose& pose)
{
  const auto& p = pose.position;
  const auto& o = pose.orientation;
  return std::isfinite(p.x + p.y + p.z + o.x + o.y + o.z + o.w);
}

/// True if all numbers of a result are finite.
bool isFinite(const WheelsetContact& result)
{
  bool finite = isFinite(result.wheelset) && std::isfinite(result.solve_time);
  for (const RailDeflection& rail : {result.left_rail, result.right_rail})
  {
    finite = finite && std::isfinite(rail.lateral + rail.vertical + rail.roll + rail.lateral_force +
                                     rail.vertical_force + rail.moment);
  }
  for (const ContactPatch& patch : result.patches)
  {
    finite = finite && isFinite(patch.pose) &&
             std::isfinite(patch.max_pressure + patch.area + patch.approach + patch.normal_force + patch.contact_angle +
                           patch.error_estimate + patch.residual + patch.half_space_ratio + patch.model_error +
                           patch.grid.dx + patch.grid.dy + patch.grid.x0 + patch.grid.y0) &&
             std::all_of(patch.grid.pressure.begin(), patch.grid.pressure.end(),
                         [](float pressure) { return std::isfinite(pressure); });
  }
  return finite;
}
}  // namespace

TEST_F(HostileInput, ResultsAreFiniteForExtremeAndNonFiniteNumbers)
{
  constexpr std::size_t fields = 13;
  constexpr double largest = std::numeric_limits<double>::max();
  const std::vector<double> values{std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity(),
                                   largest,
                                   -largest,
                                   std::numeric_limits<double>::denorm_min(),
                                   0.0};
  for (std::size_t field = 0; field < fields; ++field)
  {
    for (const double value : values)
    {
      const ros::Time stamp = ContactClient::nextStamp();
      Pose pose = ContactClient::pose(0, stamp);
      Load load = ContactClient::load(-200e3, stamp);
      auto& p = pose.pose.position;
      auto& o = pose.pose.orientation;
      auto& f = load.wrench.force;
      auto& t = load.wrench.torque;
      *std::array<double*, fields>{
          &p.x, &p.y, &p.z, &o.x, &o.y, &o.z, &o.w, &f.x, &f.y, &f.z, &t.x, &t.y, &t.z}[field] = value;
      const auto result = client_.request(pose, load);
      sent_ += 2;
      ASSERT_TRUE(result) << "field " << field << " = " << value;
      EXPECT_TRUE(isFinite(*result)) << "field " << field << " = " << value << "\n" << result->status_text;
      EXPECT_TRUE(std::isfinite(value) || result->status == WheelsetContact::INVALID_INPUT)
          << "field " << field << " = " << value;
    }
  }
  expectAllCounted();
}

TEST_F(HostileInput, FrameNamesMayBeHugeEmptyOrBinary)
{
  using namespace std::string_literals;
  for (const std::string& name :
       {std::string(1 << 20, 'x'), std::string(1 << 20, '\0'), ""s, "/"s, "\xff\xfe\n\0 %s%n"s, "track\0"s, " track"s})
  {
    for (const bool of_load : {false, true})
    {
      const ros::Time stamp = ContactClient::nextStamp();
      Pose pose = ContactClient::pose(0, stamp);
      Load load = ContactClient::load(-200e3, stamp);
      (of_load ? load.header : pose.header).frame_id = name;
      const auto result = client_.request(pose, load);
      sent_ += 2;
      ASSERT_TRUE(result) << name.substr(0, 20);
      EXPECT_LT(result->status_text.size(), 1000U);
      EXPECT_EQ(result->status == WheelsetContact::OK, of_load && name.empty()) << name.substr(0, 20);
    }
  }
  expectAllCounted();
}

TEST_F(HostileInput, StampsMayDecrease)
{
  for (const double stamp : {5000.0, 10.003, 10.002, 10.001, 1e-9, 4e9})
  {
    const ros::Time time(stamp);
    const auto result = client_.request(ContactClient::pose(0, time), ContactClient::load(-200e3, time));
    sent_ += 2;
    ASSERT_TRUE(result) << stamp;
    EXPECT_EQ(result->header.stamp, time);
    EXPECT_EQ(result->status, WheelsetContact::OK) << result->status_text;
  }
  expectAllCounted();
  // Poses and loads may arrive in another order than they were sent. Not all of these pairs are then formed.
  for (int i = 50; i > 0; --i)
  {
    sendPair(0, ros::Time(0.001 * i));
  }
  expectAllCounted();
}

TEST_F(HostileInput, UnmatchedMessagesAreDroppedAndCounted)
{
  sendPair(0, ContactClient::nextStamp());  // discards waiting messages of a previous test
  expectAllCounted();
  const std::uint64_t more = 30;
  for (std::uint64_t i = 0; i < 1000 + more; ++i)  // InputPairing::capacity
  {
    client_.send(ContactClient::pose(0, ContactClient::nextStamp()));
    ++sent_;
    spinUntil([] { return true; });
  }
  expectAllCounted();
  EXPECT_EQ(change("messages dropped: queue full while waiting for a match"), more);
  EXPECT_EQ(change("results"), 1U);
  EXPECT_EQ(after_.level, diagnostic_msgs::DiagnosticStatus::WARN) << after_.message;
  // A later pair discards the waiting messages.
  sendPair(0, ContactClient::nextStamp());
  expectAllCounted();
  EXPECT_EQ(change("results"), 2U);
  EXPECT_EQ(number(after_, "messages waiting for a match"), 0U);
}

TEST_F(HostileInput, FloodKeepsTheNewestPairsAndCountsTheDroppedOnes)
{
  constexpr int pairs = 20000;
  const double lateral[] = {0, 0.0065};  // [m], so far apart that the warm start saves no time
  ros::Time last;
  resetPeakMemory();
  const double before = memory("VmRSS");
  for (int i = 0; i < pairs; ++i)
  {
    last = ContactClient::nextStamp();
    sendPair(lateral[i % 2], last);
  }
  expectAllCounted();
  EXPECT_GT(change("inputs dropped: overload"), 0U) << "the node was fast enough for all pairs";
  ASSERT_FALSE(client_.results().empty());
  EXPECT_EQ(client_.results().back().header.stamp, last) << "the newest pair must be evaluated";
  EXPECT_LT(memory("VmHWM") - before, 100);
  EXPECT_TRUE(client_.request(0.001)) << "no result after the flood";
}

TEST_F(HostileInput, FloodOfLongMessagesTakesBoundedMemory)
{
  constexpr int pairs = 2000;
  const std::string name(100000, 'x');
  ASSERT_TRUE(client_.request(0.001));
  sent_ += 2;
  resetPeakMemory();
  const double before = memory("VmRSS");
  for (int i = 0; i < pairs; ++i)
  {
    const ros::Time stamp = ContactClient::nextStamp();
    Pose pose = ContactClient::pose(0, stamp);
    Load load = ContactClient::load(-200e3, stamp);
    pose.header.frame_id = load.header.frame_id = name;
    client_.send(pose);
    client_.send(load);
    sent_ += 2;
  }
  expectAllCounted();
  EXPECT_GT(change("inputs dropped: overload"), 0U) << "the node was fast enough for all pairs";
  // The size of all messages is 400 MB.
  EXPECT_LT(memory("VmHWM") - before, 100);
}
