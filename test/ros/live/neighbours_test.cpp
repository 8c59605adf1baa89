// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/package.h>

#include <wheel_rail_contact/EvaluateWheelset.h>
#include "config/compliance_table_file.h"
#include "contact_client.h"
#include "ros/evaluation/conversions.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double inclination = 0.025;  ///< of the rails, default [rad]

core::RailForce forceOf(const core::RailResult& rail)
{
  return {rail.lateral_force, rail.vertical_force, rail.moment};
}

/// Two wheelsets 2.5 m apart, and a wheelset without neighbours that has the same inputs as the one behind.
class LiveNeighbours : public testing::Test
{
 protected:
  /// Sends a pair to the wheelset behind and to the one without neighbours. @return the result of the first
  core::WheelsetResult requestBehind(double y, const ros::Time& stamp)
  {
    const auto pose = ContactClient::pose(y, stamp);
    const auto load = ContactClient::load(-200e3, stamp);
    const auto behind = behind_.request(pose, load), alone = alone_.request(pose, load);
    EXPECT_TRUE(behind && alone);
    alone_result_ = alone ? fromMessage(*alone) : core::WheelsetResult();
    return behind ? fromMessage(*behind) : core::WheelsetResult();
  }

  /// Deflection of a rail less the deflection by the forces of the same result.
  core::RailDeflection offsetOf(const core::RailResult& rail) const
  {
    const core::RailDeflection own = deflectionInTrack(file_.table, forceOf(rail), inclination);
    return {rail.deflection.lateral - own.lateral, rail.deflection.vertical - own.vertical,
            rail.deflection.roll - own.roll};
  }

  const ComplianceTableFile file_ =
      readComplianceTable(ros::package::getPath("wheel_rail_contact") + "/config/rails/pads_10_25.yaml");
  ContactClient front_{"/front", "/front/contact_node"};
  ContactClient behind_{"/behind", "/behind/contact_node"};
  ContactClient alone_{"/alone", "/alone/contact_node"};
  core::WheelsetResult alone_result_;
};

void expectSameRails(const core::WheelsetResult& a, const core::WheelsetResult& b)
{
  ASSERT_EQ(a.status, core::ContactStatus::ok) << a.reason;
  for (const core::Side side : core::sides)
  {
    EXPECT_EQ(a.rail[side].deflection.lateral, b.rail[side].deflection.lateral);
    EXPECT_EQ(a.rail[side].deflection.vertical, b.rail[side].deflection.vertical);
    EXPECT_EQ(a.rail[side].deflection.roll, b.rail[side].deflection.roll);
  }
}
}  // namespace

// The front wheelset touches the left rail with its flange, so that its two rails deflect differently. Deflection and
// forces of a result satisfy the table within rounding; the bounds are 1e-6 of the largest effect of the neighbour.
TEST_F(LiveNeighbours, ForcesOfTheOtherWheelsetDeflectTheRailsAsInTheTable)
{
  expectSameRails(requestBehind(1e-3, ContactClient::nextStamp()), alone_result_);

  const auto front = front_.request(6.5e-3);
  ASSERT_TRUE(front);
  ASSERT_EQ(front->status, WheelsetContact::OK) << front->status_text;
  const core::WheelsetResult forces = fromMessage(*front);
  const core::ComplianceTable& influence = file_.neighbours.at(1).influence;
  ASSERT_EQ(file_.neighbours.at(1).distance, 2.5);

  // The result may reach the wheelset behind later than this program.
  core::WheelsetResult behind;
  const auto has_offset = [&] { return std::abs(offsetOf(behind.rail.left).lateral) > 1e-5; };
  for (int i = 0; i < 20 && !has_offset(); ++i)
  {
    behind = requestBehind(1e-3, ContactClient::nextStamp());
  }
  ASSERT_TRUE(has_offset());
  for (const core::Side side : core::sides)
  {
    SCOPED_TRACE(nameOf(side));
    const core::RailDeflection found = offsetOf(behind.rail[side]);
    const core::RailDeflection expected = deflectionInTrack(influence, forceOf(forces.rail[side]), inclination);
    EXPECT_NEAR(found.lateral, expected.lateral, 1e-9);
    EXPECT_NEAR(found.vertical, expected.vertical, 1e-9);
    EXPECT_NEAR(found.roll, expected.roll, 1e-8);
    const core::RailDeflection without = offsetOf(alone_result_.rail[side]);
    EXPECT_NEAR(without.lateral, 0, 1e-9);
    EXPECT_NEAR(without.vertical, 0, 1e-9);
    EXPECT_NEAR(without.roll, 0, 1e-8);
    RecordProperty(nameOf(side),
                   std::to_string(1e6 * expected.lateral) + " um, " + std::to_string(1e3 * expected.roll) + " mrad");
  }
  EXPECT_GT(std::abs(offsetOf(behind.rail.left).lateral - offsetOf(behind.rail.right).lateral), 1e-5);

  const std::string lacking = "results that lack a neighbour's forces";
  const int lacked = std::stoi(nextReport("/behind/contact_node").values[lacking]);
  EXPECT_GE(lacked, 1) << "at least the first result";
  expectSameRails(requestBehind(1e-3, front->header.stamp + ros::Duration(1.5)), alone_result_);
  EXPECT_EQ(std::stoi(nextReport("/behind/contact_node").values[lacking]), lacked + 1);
  EXPECT_EQ(nextReport("/alone/contact_node").values[lacking], "0");
}

TEST_F(LiveNeighbours, ServiceResultsWithoutTheirForcesHaveAWarningAndAreCounted)
{
  ASSERT_TRUE(front_.request(1e-3));
  const std::string lacking = "service results that lack a neighbour's forces";
  const std::string warning = "forces of a neighbour are unknown, and taken as zero";
  const int before = std::stoi(nextReport("/behind/contact_node").values[lacking]);
  const auto text_at = [](const ros::Time& stamp, const std::string& service)
  {
    EvaluateWheelset call;
    call.request.pose = ContactClient::pose(1e-3, stamp);
    call.request.load = ContactClient::load(-200e3, stamp);
    EXPECT_TRUE(ros::service::call("/behind/contact_node/" + service, call));
    EXPECT_EQ(call.response.contact.status, WheelsetContact::OK);
    return call.response.contact.status_text;
  };
  const ros::Time stamp = ContactClient::nextStamp();
  // The result of the neighbour may reach the node later than this program.
  EXPECT_TRUE(spinUntil([&] { return text_at(stamp, "evaluate").empty(); }, 10));
  const int late = std::stoi(nextReport("/behind/contact_node").values[lacking]);
  EXPECT_EQ(text_at(ros::Time(), "evaluate"), warning) << "the time is unknown";
  EXPECT_EQ(text_at(ros::Time(), "static_start"), warning);
  EXPECT_EQ(text_at(stamp, "static_start"), "");
  EXPECT_GE(late, before);
  EXPECT_EQ(std::stoi(nextReport("/behind/contact_node").values[lacking]), late + 2);
}
