// SPDX-License-Identifier: BSD-3-Clause
// The services ~evaluate and ~static_start, and held results.
#include <atomic>
#include <thread>

#include <wheel_rail_contact/EvaluateWheelset.h>
#include "../message_bytes.h"
#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double wheelset_load = 200e3;  ///< [N]
/// Largest error of the vertical force of a wheel [N]: it is solved under its load, which the balance leaves open by
/// less than 1e-5.
constexpr double load_error = 1;

EvaluateWheelset state(double y, const ros::Time& stamp)
{
  EvaluateWheelset call;
  call.request.pose = ContactClient::pose(y, stamp);
  call.request.load = ContactClient::load(-wheelset_load, stamp);
  return call;
}

/// Result of a service for a state.
WheelsetContact resultOf(const std::string& service, EvaluateWheelset call)
{
  EXPECT_TRUE(ros::service::waitForService(service, ros::Duration(60))) << service;
  EXPECT_TRUE(ros::service::call(service, call)) << service;
  return call.response.contact;
}

/// A pose beside the rail, for which there is no result.
EvaluateWheelset beyondTheProfile(const ros::Time& stamp)
{
  return state(0.09, stamp);
}
}  // namespace

TEST(EvaluateService, GivesTheBytesOfTheTopicForTheSameSequenceOfStates)
{
  ContactClient client;
  for (const double y : {0.0, 1e-3, 2e-3, 6e-3})
  {
    const EvaluateWheelset call = state(y, ContactClient::nextStamp() + ros::Duration(100));
    const auto by_topic = client.request(call.request.pose, call.request.load);
    ASSERT_TRUE(by_topic);
    EXPECT_EQ(bytesWithoutTime(resultOf("/contact_node/evaluate", call)), bytesWithoutTime(*by_topic)) << y;
  }
}

TEST(EvaluateService, DoesNotChangeTheResultsOnTheTopics)
{
  ContactClient client;
  const ros::Time stamp = ContactClient::nextStamp() + ros::Duration(1000);
  const auto cold = client.request(ContactClient::pose(1e-3, stamp), ContactClient::load(-wheelset_load, stamp));
  resultOf("/contact_node/evaluate", state(7e-3, stamp));  // another state, from which a warm start would differ
  const auto warm = client.request(ContactClient::pose(1.1e-3, stamp), ContactClient::load(-wheelset_load, stamp));
  const ros::Time later = stamp + ros::Duration(1);  // a new second: cold again
  const auto cold_again = client.request(ContactClient::pose(1e-3, later), ContactClient::load(-wheelset_load, later));
  auto warm_again = client.request(ContactClient::pose(1.1e-3, later), ContactClient::load(-wheelset_load, later));
  ASSERT_TRUE(cold && warm && cold_again && warm_again);
  warm_again->header = warm->header;
  EXPECT_EQ(bytesWithoutTime(*warm), bytesWithoutTime(*warm_again));
}

TEST(EvaluateService, EveryRequestHasAResultWithAStatusAndIsCounted)
{
  const Report before = nextReport("/contact_node");
  EvaluateWheelset call = state(0, ContactClient::nextStamp());
  call.request.pose.pose.position.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(resultOf("/contact_node/evaluate", call).status, WheelsetContact::INVALID_INPUT);
  EXPECT_EQ(resultOf("/contact_node/evaluate", EvaluateWheelset()).status, WheelsetContact::INVALID_INPUT)
      << "all zero";
  call = state(0, ContactClient::nextStamp());
  call.request.pose.header.frame_id = "nowhere";
  EXPECT_EQ(resultOf("/contact_node/evaluate", call).status, WheelsetContact::NO_TRANSFORM);
  EXPECT_EQ(resultOf("/contact_node/evaluate", state(0, ros::Time())).status, WheelsetContact::OK) << "stamp 0";
  Report after = nextReport("/contact_node");
  const auto change = [&](const char* key) { return std::stoi(after.values[key]) - std::stoi(before.values.at(key)); };
  for (int i = 0; i < 5 && change("service results ~evaluate") < 4; ++i)
  {
    after = nextReport("/contact_node");
  }
  EXPECT_EQ(change("service results ~evaluate"), 4);
  EXPECT_EQ(change("service results that are not usable"), 3);
  EXPECT_EQ(change("results"), 0) << "only pairs of the topics are counted there";
}

TEST(EvaluateService, UsesOnlyTheInputsThatTheParametersRequire)
{
  EvaluateWheelset call = state(0, ContactClient::nextStamp());
  call.request.left_rail_force.wrench.force.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(resultOf("/contact_node/evaluate", call).status, WheelsetContact::OK);
  EXPECT_EQ(resultOf("/forces/contact_node/evaluate", call).status, WheelsetContact::INVALID_INPUT);
  call.request.left_rail_force.wrench.force.y = 20e3;
  EXPECT_EQ(resultOf("/forces/contact_node/evaluate", call).left_rail.lateral_force, 20e3);
}

TEST(EvaluateService, RequiresTheTwistOnlyWithFriction)
{
  EvaluateWheelset call = state(2e-3, ContactClient::nextStamp());
  const WheelsetContact refused = resultOf("/rolling/contact_node/evaluate", call);
  EXPECT_EQ(refused.status, WheelsetContact::INVALID_INPUT);
  EXPECT_EQ(refused.status_text, "twist: frame_id is '', but must be 'track' (track/frame)");
  EXPECT_EQ(resultOf("/contact_node/evaluate", call).status, WheelsetContact::OK);
  call.request.twist.header.frame_id = "track";
  call.request.twist.twist.linear.x = -20;
  for (const char* service : {"/rolling/contact_node/evaluate", "/rolling/contact_node/static_start"})
  {
    const WheelsetContact result = resultOf(service, call);
    ASSERT_EQ(result.status, WheelsetContact::OK) << result.status_text;
    EXPECT_EQ(result.speed, -20);
    EXPECT_NEAR(result.rotation, -20 / 0.46, 0.1) << "free rolling on a wheel of 0.46 m";
    EXPECT_LT(result.left_wheel.friction_lateral_force, -1e3) << "spin pushes the rail inward";
    EXPECT_NEAR(result.left_wheel.vertical_force + result.right_wheel.vertical_force, wheelset_load, 2 * load_error);
  }
}

TEST(EvaluateService, TopicsAreEvaluatedWhileARequestWaits)
{
  ContactClient client;
  std::atomic<bool> waits{true};
  std::thread caller(
      [&waits]
      {
        EvaluateWheelset call = state(0, ros::Time(1));
        call.request.pose.header.frame_id = "nowhere";
        for (int i = 0; i < 10; ++i)  // each waits 0.1 s for the transform
        {
          EXPECT_EQ(resultOf("/contact_node/evaluate", call).status, WheelsetContact::NO_TRANSFORM);
        }
        waits = false;
      });
  int results = 0;
  while (waits)
  {
    ASSERT_TRUE(client.request(0.0));
    results += waits ? 1 : 0;
  }
  caller.join();
  EXPECT_GT(results, 10) << "at least one result for each request that waits";
}

TEST(StaticStart, GivesHeightAndRollOfTheLoadWhereTheHeightIsGiven)
{
  EvaluateWheelset call = state(1e-3, ContactClient::nextStamp());
  call.request.load.wrench.torque.x = 10e3;
  const WheelsetContact start = resultOf("/given/contact_node/static_start", call);
  ASSERT_EQ(start.status, WheelsetContact::OK) << start.status_text;
  // The wheel loads differ by the moment over half the distance of the running circles, 0.75 m.
  const double difference = start.right_rail.vertical_force - start.left_rail.vertical_force;
  EXPECT_NEAR(difference, 10e3 / 0.75, 2 * load_error);
  EXPECT_NEAR(start.left_rail.vertical_force + start.right_rail.vertical_force, wheelset_load, 2 * load_error);

  // The node with the given height has these forces at this height and roll.
  call.request.pose.pose = start.wheelset;
  const WheelsetContact given = resultOf("/given/contact_node/evaluate", call);
  ASSERT_EQ(given.status, WheelsetContact::OK) << given.status_text;
  EXPECT_NEAR(given.left_rail.vertical_force, start.left_rail.vertical_force, 0.01 * wheelset_load);
  EXPECT_NEAR(given.right_rail.vertical_force, start.right_rail.vertical_force, 0.01 * wheelset_load);
}

TEST(StaticStart, DoesNotDependOnEarlierRequests)
{
  const EvaluateWheelset call = state(1e-3, ContactClient::nextStamp());
  const WheelsetContact first = resultOf("/contact_node/static_start", call);
  resultOf("/contact_node/static_start", state(6e-3, ContactClient::nextStamp()));
  EXPECT_EQ(bytesWithoutTime(resultOf("/contact_node/static_start", call)), bytesWithoutTime(first));
}

TEST(HeldResult, HasTheForcesOfTheLastUsableOneOnTheTopicAndFromTheService)
{
  ContactClient client("/holding", "/holding/contact_node");
  const EvaluateWheelset usable = state(1e-3, ContactClient::nextStamp());
  const auto by_topic = client.request(usable.request.pose, usable.request.load);
  ASSERT_TRUE(by_topic && by_topic->status == WheelsetContact::OK);
  resultOf("/holding/contact_node/evaluate", usable);
  for (int i = 0; i < 3; ++i)
  {
    const EvaluateWheelset refused = beyondTheProfile(ContactClient::nextStamp());
    const auto result = client.request(refused.request.pose, refused.request.load);
    ASSERT_TRUE(result);
    EXPECT_GT(result->status, WheelsetContact::LIFT_OFF);
    EXPECT_EQ(result->held, i < 2);
    EXPECT_EQ(result->patches.size(), i < 2 ? by_topic->patches.size() : 0U);
    EXPECT_EQ(bytesOf(result->left_wheel), bytesOf(i < 2 ? by_topic->left_wheel : WheelForces()));
    EXPECT_EQ(result->wheelset.position.z, by_topic->wheelset.position.z);
    EXPECT_EQ(bytesWithoutTime(resultOf("/holding/contact_node/evaluate", refused)), bytesWithoutTime(*result));
  }
}

TEST(HeldResult, OfAnInputWithoutAPositionHasThePoseOfTheLastUsableOne)
{
  ContactClient client("/holding", "/holding/contact_node");
  EvaluateWheelset usable = state(1e-3, ContactClient::nextStamp());
  usable.request.pose.pose.position.x = 52;
  const auto last = client.request(usable.request.pose, usable.request.load);
  ASSERT_TRUE(last && last->status == WheelsetContact::OK);
  EvaluateWheelset refused = state(1e-3, ContactClient::nextStamp());
  refused.request.pose.pose.position.x = std::numeric_limits<double>::quiet_NaN();
  const auto held = client.request(refused.request.pose, refused.request.load);
  ASSERT_TRUE(held && held->held);
  EXPECT_EQ(held->status, WheelsetContact::INVALID_INPUT);
  EXPECT_EQ(bytesOf(held->wheelset), bytesOf(last->wheelset));
  EXPECT_EQ(bytesOf(held->patches.at(0)), bytesOf(last->patches.at(0)));
}
