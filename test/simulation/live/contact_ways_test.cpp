// SPDX-License-Identifier: BSD-3-Clause
// The same closed loop with the ways to the contact. The node runs with the default parameters, as the library does.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "examples/simulate_wheelset/in_process_contact.h"
#include "examples/simulate_wheelset/message_reply.h"
#include "examples/simulate_wheelset/service_contact.h"
#include "examples/simulate_wheelset/topic_contact.h"
#include "examples/simulate_wheelset/wheelset_dynamics.h"

namespace simulate_wheelset
{
namespace
{
constexpr int steps = 1200;  ///< with a whole second, and several times 200 results: warm-start resets of the node

/// Motions of a wheelset at 40 m/s that starts displaced by 3 mm.
std::vector<Motion> motionsWith(ContactSource& source)
{
  WheelsetDynamics dynamics((Parameters()));
  std::vector<Motion> motions;
  double roll = 0;
  for (int i = 0; i < steps; ++i)
  {
    const ContactReply contact = source.evaluate(dynamics.request(i * 1'000'000LL, roll));
    EXPECT_TRUE(contact.is_usable) << contact.status;
    roll = contact.roll;
    dynamics.advance(contact);
    motions.push_back(dynamics.motion());
  }
  return motions;
}

double largestDifference(const std::vector<Motion>& a, const std::vector<Motion>& b, double Motion::*quantity)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i].*quantity - b[i].*quantity));
  }
  return largest;
}

std::vector<Motion> motionsInProcess()
{
  InProcessContact contact(readContactParameters(""));
  return motionsWith(contact);
}

/// Checks that motions are those in process.
///
/// The node starts its solver cold at every whole second and after 200 results, the library never. Both solutions are
/// within contact/tolerance, 1 %, of the exact one, and differ much less: forces by less than 3e-4. That moves a wave
/// of 3 mm by less than 1 um, and its yaw of 3 mm 2 pi / 9 m = 2 mrad by less than 1 urad.
void expectMotionsInProcess(const std::vector<Motion>& motions)
{
  const std::vector<Motion> expected = motionsInProcess();
  EXPECT_LT(largestDifference(motions, expected, &Motion::y), 1e-6);
  EXPECT_LT(largestDifference(motions, expected, &Motion::yaw), 1e-6);
}

TEST(ContactWays, TopicsGiveTheMotionOfTheLibrary)
{
  TopicContact contact("contact_node", "track");
  expectMotionsInProcess(motionsWith(contact));
}

TEST(ContactWays, ServiceGivesTheMotionOfTheLibrary)
{
  ServiceContact contact("contact_node", "track");
  expectMotionsInProcess(motionsWith(contact));
}

TEST(ContactWays, NodeThatBalancesMomentsIsRefused)
{
  ros::param::set("/other_node/wheelset/balance", "moments");
  EXPECT_THROW(TopicContact("other_node", "track"), std::runtime_error);
  EXPECT_NO_THROW(refuseBalanceOfMoments("contact_node"));
}

template <typename Contact>
void expectReasonOfUnusableState()
{
  Contact contact("contact_node", "track");
  ContactRequest request;
  request.y = 0.5;
  request.force_z = -200e3;
  const ContactReply reply = contact.evaluate(request);
  EXPECT_FALSE(reply.is_usable);
  EXPECT_NE(reply.status, "");
}

TEST(ContactWays, UnusableStateIsReportedWithItsReason)
{
  expectReasonOfUnusableState<TopicContact>();
  expectReasonOfUnusableState<ServiceContact>();
}
}  // namespace
}  // namespace simulate_wheelset

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "contact_ways_test");
  const ros::NodeHandle alive;
  return RUN_ALL_TESTS();
}
