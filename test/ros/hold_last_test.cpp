// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/hold_last.h"

#include <boost/make_shared.hpp>

#include "../usual_headers.h"
#include "message_bytes.h"
#include "ros/evaluation/conversions.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double height = 0.46;          ///< of the axle of a usable result [m]
constexpr double roll = 1e-3;            ///< of a usable result [rad]
constexpr double yaw = 2e-3;             ///< of each input [rad]
constexpr double wheel_force = 100e3;    ///< of a usable result [N]
constexpr double rounding = 1e-15;       ///< of positions and angles
constexpr std::uint64_t step = 1000000;  ///< of the stamps [ns]

using Result = boost::shared_ptr<const WheelsetContact>;

/// Result with a stamp of `number` steps, at x = `number` metres. A usable one has one patch 1 mm ahead of the axle.
ContactOutput result(int number, std::uint8_t status)
{
  ContactOutput output;
  output.header.stamp.fromNSec(step * static_cast<std::uint64_t>(number));
  output.status = status;
  output.state.x = number;
  output.state.yaw = yaw;
  if (!isUsable(status))
  {
    output.reason = "refused";
    return output;
  }
  core::WheelsetResult solved;
  solved.yaw = yaw;
  if (status == WheelsetContact::OK)
  {
    solved.z = height;
    solved.roll = roll;
    solved.wheel.left.vertical = solved.rail.left.vertical_force = wheel_force;
    solved.rail_wrench.force.z() = wheel_force;
    solved.derivatives.forces.setOnes(6, 4);
    core::PatchResult& patch = solved.patches.emplace_back();
    patch.pose.x = 1e-3;
    patch.normal_force = wheel_force;
  }
  output.result = std::make_shared<const core::WheelsetResult>(solved);
  return output;
}

NodeConfig config(int longest)
{
  NodeConfig node_config;
  node_config.hold_last = longest;
  return node_config;
}

/// Message of a result after HoldLast.
Result applied(HoldLast& hold, ContactOutput output)
{
  hold.apply(output);
  return boost::make_shared<const WheelsetContact>(toMessage(output, true));
}

Result applied(HoldLast& hold, int number, std::uint8_t status)
{
  return applied(hold, result(number, status));
}

/// Statuses of inputs that may be rejected before the evaluation: NaN, and no transform.
constexpr std::array<std::uint8_t, 2> rejections{WheelsetContact::INVALID_INPUT, WheelsetContact::NO_TRANSFORM};

/// Applied result of an input that was rejected before the evaluation, with a stamp of `number` steps.
Result appliedRejection(HoldLast& hold, int number, std::uint8_t status)
{
  ContactOutput output = result(number, status);
  output.state = {};
  output.rejected = true;
  return applied(hold, output);
}

void expectLastHeight(const WheelsetContact& message)
{
  const auto& o = message.wheelset.orientation;
  EXPECT_DOUBLE_EQ(message.wheelset.position.z, height);
  EXPECT_NEAR(2 * std::atan2(o.x, o.w), roll, rounding);
  EXPECT_NEAR(2 * std::atan2(o.z, o.w), yaw, rounding) << "yaw is that of the input";
}
}  // namespace

TEST(HoldLast, UnusableResultHasTheHeightAndRollOfTheLastUsableOne)
{
  HoldLast hold(config(0));
  applied(hold, 1, WheelsetContact::OK);
  for (const std::uint8_t status : {WheelsetContact::NOT_CONVERGED, WheelsetContact::INVALID_INPUT})
  {
    const Result refused = applied(hold, 2, status);
    expectLastHeight(*refused);
    EXPECT_EQ(refused->wheelset.position.x, 2);
    EXPECT_EQ(refused->status, status);
    EXPECT_EQ(refused->status_text, "refused");
    EXPECT_FALSE(refused->held);
    EXPECT_TRUE(refused->patches.empty());
  }
}

TEST(HoldLast, ResultWithoutAPoseStaysWithoutOneUnlessItIsHeld)
{
  for (const std::uint8_t status : rejections)
  {
    HoldLast hold(config(0));
    applied(hold, 52, WheelsetContact::OK);
    const Result refused = appliedRejection(hold, 53, status);
    EXPECT_EQ(bytesOf(refused->wheelset), bytesOf(geometry_msgs::Pose()));
    EXPECT_EQ(refused->status_text, "refused");
  }
}

TEST(HoldLast, HeldResultWithoutAPoseHasThePoseAndThePatchesOfTheLastUsableOne)
{
  for (const std::uint8_t status : rejections)
  {
    HoldLast hold(config(1));
    ContactOutput last = result(52, WheelsetContact::OK);
    last.state.distance = 1052;
    const Result usable = applied(hold, last);
    const Result held = appliedRejection(hold, 53, status);
    EXPECT_TRUE(held->held);
    EXPECT_EQ(held->status, status);
    EXPECT_EQ(bytesOf(held->wheelset), bytesOf(usable->wheelset));
    EXPECT_EQ(held->distance, 1052);
    EXPECT_EQ(usable->derivatives.forces.size(), 24U);
    EXPECT_TRUE(held->derivatives.forces.empty()) << "a held force does not change";
    ASSERT_EQ(held->patches.size(), 1U);
    EXPECT_EQ(held->patches[0].pose.position.x, usable->patches[0].pose.position.x) << "the patch does not move";
    EXPECT_EQ(held->status_text,
              "refused; pose, forces and patches are held from the result at 0.052000000 s (1 of at most 1)");
    EXPECT_EQ(bytesOf(appliedRejection(hold, 54, status)->wheelset), bytesOf(geometry_msgs::Pose()))
        << "no longer held";
  }
}

TEST(HoldLast, InputAtTheOriginHasAPose)
{
  HoldLast hold(config(0));
  applied(hold, 1, WheelsetContact::OK);
  ContactOutput at_origin = result(2, WheelsetContact::INVALID_INPUT);
  at_origin.state = {};
  const Result refused = applied(hold, at_origin);
  EXPECT_EQ(refused->wheelset.position.x, 0);
  EXPECT_DOUBLE_EQ(refused->wheelset.position.z, height);
}

TEST(HoldLast, ReleasedResultGivesHeightAndRollToTheNext)
{
  HoldLast hold(config(0));
  ContactOutput usable = result(1, WheelsetContact::OK);
  usable.release();
  EXPECT_EQ(usable.result, nullptr);
  hold.apply(usable);
  expectLastHeight(*applied(hold, 2, WheelsetContact::NOT_CONVERGED));
  hold.restart();
  EXPECT_EQ(applied(hold, 3, WheelsetContact::NOT_CONVERGED)->wheelset.position.z, 0);
}

TEST(HoldLast, UsableResultAndThoseBeforeTheFirstOneAreNotChanged)
{
  HoldLast hold(config(3));
  const Result refused = applied(hold, 1, WheelsetContact::NOT_CONVERGED);
  EXPECT_EQ(refused->wheelset.position.z, 0);
  EXPECT_FALSE(refused->held);
  applied(hold, 1, WheelsetContact::OK);
  const Result lifted = applied(hold, 2, WheelsetContact::LIFT_OFF);
  EXPECT_EQ(lifted->wheelset.position.z, 0);
  EXPECT_FALSE(lifted->held);
  EXPECT_TRUE(lifted->patches.empty()) << "a wheel that has lifted off is a result, not a refusal";
}

TEST(HoldLast, ForcesAndPatchesAreHeldForTheGivenNumberOfResults)
{
  HoldLast hold(config(2));
  applied(hold, 1, WheelsetContact::OK);
  for (int number = 2; number <= 3; ++number)
  {
    const Result held = applied(hold, number, WheelsetContact::OFF_PROFILE);
    EXPECT_TRUE(held->held);
    EXPECT_EQ(held->status, WheelsetContact::OFF_PROFILE);
    EXPECT_EQ(held->left_wheel.vertical_force, wheel_force);
    EXPECT_EQ(held->left_rail.vertical_force, wheel_force);
    EXPECT_EQ(held->rail_wrench.force.z, wheel_force);
    ASSERT_EQ(held->patches.size(), 1U);
    EXPECT_EQ(held->patches[0].normal_force, wheel_force);
    EXPECT_NEAR(held->patches[0].pose.position.x, number + 1e-3, 1e-12) << "the patch moves with the wheelset";
    EXPECT_EQ(held->status_text, "refused; forces and patches are held from the result at 0.001000000 s (" +
                                     std::to_string(number - 1) + " of at most 2)");
  }
  const Result refused = applied(hold, 4, WheelsetContact::OFF_PROFILE);
  EXPECT_FALSE(refused->held);
  EXPECT_TRUE(refused->patches.empty());
  expectLastHeight(*refused);
}

TEST(HoldLast, UsableResultStartsTheCountAgain)
{
  HoldLast hold(config(1));
  for (int number = 1; number < 9; number += 2)
  {
    applied(hold, number, WheelsetContact::OK);
    EXPECT_TRUE(applied(hold, number + 1, WheelsetContact::NOT_CONVERGED)->held);
  }
}

TEST(HoldLast, RepeatedStampIsHeldUntilTimeGoesBack)
{
  HoldLast hold(config(5));
  applied(hold, 5, WheelsetContact::OK);
  EXPECT_TRUE(applied(hold, 5, WheelsetContact::NOT_CONVERGED)->held);
  const Result refused = applied(hold, 4, WheelsetContact::NOT_CONVERGED);
  EXPECT_FALSE(refused->held);
  EXPECT_EQ(refused->wheelset.position.z, 0);
}

TEST(HoldLast, LastUsableResultIsForgottenAfterItsMemory)
{
  HoldLast hold(config(HoldLast::memory));
  applied(hold, 1, WheelsetContact::OK);
  for (int number = 0; number < HoldLast::memory; ++number)
  {
    EXPECT_TRUE(applied(hold, 2 + number, WheelsetContact::NOT_CONVERGED)->held);
  }
  const Result refused = applied(hold, 2 + HoldLast::memory, WheelsetContact::NOT_CONVERGED);
  EXPECT_FALSE(refused->held);
  EXPECT_EQ(refused->wheelset.position.z, 0);
}

TEST(HoldLast, GivenHeightIsThatOfTheInput)
{
  NodeConfig given = config(1);
  given.model.wheelset.solve_height_and_roll = false;
  HoldLast hold(given);
  applied(hold, 1, WheelsetContact::OK);
  const Result held = applied(hold, 2, WheelsetContact::TOO_DEEP);
  EXPECT_TRUE(held->held);
  EXPECT_EQ(held->wheelset.position.z, 0);
}
