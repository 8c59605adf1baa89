// SPDX-License-Identifier: BSD-3-Clause
// The same closed loop with the ways to the contact. The node runs with the default parameters, as the library does.
#include <ros/ros.h>

#include "examples/simulate_wheelset/closed_loop.h"
#include "examples/simulate_wheelset/contact_ways.h"
#include "examples/simulate_wheelset/wheelset_dynamics.h"
#include "simulation/sweep.h"

namespace simulate_wheelset
{
namespace
{
constexpr int steps = 1200;  ///< with a whole second, and several times 200 results: warm-start resets of the node

/// Motions of a wheelset at 40 m/s that starts displaced by 3 mm.
std::vector<Motion> motionsWith(ContactSource& source)
{
  WheelsetDynamics dynamics((Parameters()));
  HeldContact held(source, 0);
  std::vector<Motion> motions;
  for (int i = 0; i < steps; ++i)
  {
    EXPECT_TRUE(isUsable(dynamics.advance(held).status));
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
  InProcessContact contact(readContact(""));
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

TEST(ContactWays, NodeThatExpectsAnotherLoadIsRefused)
{
  EXPECT_THROW(TopicContact("default_balance", "track"), std::runtime_error);
  ros::param::set("/frictionless/wheelset/balance", "moments");
  EXPECT_THROW(TopicContact("frictionless", "track"), std::runtime_error);
  ros::param::set("/given_height/wheelset/balance", "moments");
  ros::param::set("/given_height/creep/method", "linear");
  EXPECT_NO_THROW(requireLoad("given_height"));
  ros::param::set("/given_height/wheelset/free", std::vector<std::string>());
  EXPECT_THROW(TopicContact("given_height", "track"), std::runtime_error);
  EXPECT_NO_THROW(requireLoad("contact_node"));
}

TEST(ContactWays, WheelsetHuntsInALimitCycleWithTheNode)
{
  ServiceContact contact("contact_node", "track");
  Parameters parameters;
  parameters.run.yaw = 0.0065;
  parameters.run.duration = 2;
  const RunSummary run = runClosedLoop(parameters, contact, nullptr);
  EXPECT_EQ(run.held, 0);
  EXPECT_GT(run.saturated, 0);
  ASSERT_GE(run.waves.count(), 2);
  // The reasons for these bounds are those of ClosedLoop.SoftGuidanceEndsInOneLimitCycleFromBothSides.
  const Sweep sweep(contact, 0.0068);
  EXPECT_GT(run.waves.largestY(), sweep.steepFrom(0.2));
  EXPECT_LT(run.waves.largestY(), sweep.steepFrom(std::atan(1.0)));
  EXPECT_GT(run.waves.wavelength(), sweep.kinematicWavelength(run.waves.largestY()));
  EXPECT_LT(run.waves.wavelength(), sweep.kinematicWavelength(0.002));
}

/// Reply beside the rails.
ContactReply unusableReply(ContactSource& contact)
{
  ContactRequest request;
  request.state.y = 0.5;
  request.state.force_z = -200e3;
  return contact.evaluate(request);
}

TEST(ContactWays, UnusableStateHasItsStatusAndReason)
{
  InProcessContact library(readContact(""));
  const ContactReply expected = unusableReply(library);
  EXPECT_STREQ(nameOf(expected.status), "INVALID_INPUT");
  EXPECT_FALSE(expected.reason.empty());
  TopicContact topics("contact_node", "track");
  ServiceContact service("contact_node", "track");
  for (ContactSource* contact : {static_cast<ContactSource*>(&topics), static_cast<ContactSource*>(&service)})
  {
    const ContactReply reply = unusableReply(*contact);
    EXPECT_EQ(reply.status, expected.status);
    EXPECT_EQ(reply.reason, expected.reason);
  }
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
