// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
/// Client that also publishes the lateral forces on both rails, as a vehicle simulation does.
class Simulation
{
 public:
  Simulation()
      : left_(nh_.advertise<geometry_msgs::WrenchStamped>("/forces/wheelset/left_rail_force", 10)),
        right_(nh_.advertise<geometry_msgs::WrenchStamped>("/forces/wheelset/right_rail_force", 10))
  {
    EXPECT_TRUE(spinUntil([this] { return left_.getNumSubscribers() > 0 && right_.getNumSubscribers() > 0; }));
  }

  /// Result for a wheelset at y = 0 with 100 kN on each wheel and given lateral forces on the rails [N].
  WheelsetContact request(double left, double right)
  {
    const ros::Time stamp = ContactClient::nextStamp();
    const std::size_t before = client_.results().size();
    client_.send(ContactClient::pose(0, stamp));
    client_.send(ContactClient::load(-200e3, stamp));
    left_.publish(force(left, stamp));
    spinUntil([] { return false; }, 0.1);
    EXPECT_EQ(client_.results().size(), before) << "evaluated without the force on the right rail";
    right_.publish(force(right, stamp));
    EXPECT_TRUE(client_.waitForResults(before + 1));
    return client_.results().size() > before ? client_.results().back() : WheelsetContact();
  }

 private:
  static geometry_msgs::WrenchStamped force(double y, const ros::Time& stamp)
  {
    geometry_msgs::WrenchStamped message;
    message.header.stamp = stamp;
    message.wrench.force.y = y;
    return message;
  }

  ros::NodeHandle nh_;
  ContactClient client_{"/forces", "/forces/contact_node"};
  ros::Publisher left_, right_;
};
}  // namespace

TEST(LiveNode, RailForcesPushBothRailsOutward)
{
  Simulation simulation;
  const auto rest = simulation.request(0, 0);
  const auto both = simulation.request(30e3, 30e3);
  ASSERT_EQ(both.status, WheelsetContact::OK) << both.status_text;
  EXPECT_EQ(both.left_rail.lateral_force, 30e3);
  EXPECT_EQ(both.right_rail.lateral_force, 30e3);
  // The lateral compliance of the table alone gives 30 kN * 60.6 nm/N = 1.8 mm. The moments of both forces change this
  // by less than half.
  EXPECT_NEAR(both.left_rail.lateral - rest.left_rail.lateral, 1.8e-3, 0.9e-3);
  EXPECT_NEAR(both.right_rail.lateral, both.left_rail.lateral, 1e-9) << "mirror image";
  EXPECT_GT(both.left_rail.roll, rest.left_rail.roll);
}

TEST(LiveNode, EachRailDeflectsByItsOwnForce)
{
  Simulation simulation;
  const auto rest = simulation.request(0, 0);
  const auto bent = simulation.request(-10e3, 20e3);
  ASSERT_EQ(bent.status, WheelsetContact::OK) << bent.status_text;
  EXPECT_EQ(bent.left_rail.lateral_force, -10e3);
  EXPECT_EQ(bent.right_rail.lateral_force, 20e3);
  EXPECT_LT(bent.left_rail.lateral, rest.left_rail.lateral) << "pulled towards the track centre";
  EXPECT_GT(bent.right_rail.lateral, rest.right_rail.lateral);
}

// The table is valid up to |Y|/Q = 0.6; Q is 100 kN.
TEST(LiveNode, RailForceBeyondTheRangeOfTheTableGivesAWarning)
{
  Simulation simulation;
  EXPECT_EQ(simulation.request(59e3, 0).status_text, "");
  const auto beyond = simulation.request(0, -61e3);
  ASSERT_EQ(beyond.status, WheelsetContact::OK) << beyond.status_text;
  const std::string warning =
      "right rail: Y = -61.0 kN at Q = 100.0 kN, |Y|/Q = 0.610; its compliance table is valid up to 0.6";
  EXPECT_EQ(beyond.status_text, warning);
  const Report report = nextReport("/forces/contact_node");
  EXPECT_EQ(report.values.at("last result beyond the table's linear range"), warning);
  EXPECT_NE(report.values.at("results beyond the table's linear range"), "0");
}

TEST(LiveNode, NonFiniteRailForceIsRefused)
{
  Simulation simulation;
  const auto result = simulation.request(0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(result.status, WheelsetContact::INVALID_INPUT);
  EXPECT_NE(result.status_text.find("right rail force"), std::string::npos) << result.status_text;
  EXPECT_EQ(simulation.request(0, 0).status, WheelsetContact::OK);
}
